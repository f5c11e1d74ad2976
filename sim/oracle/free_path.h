// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "hardware/types/config_error.h"
#include "sim/oracle/collision_oracle.h"

namespace horopter::sim {

/// Which way to look for: of a robot, as an upright cylinder around whatever its heading is, from a
/// start to a goal.
struct PathQuery {
  UprightCylinder robot;
  Eigen::Vector2d start_W = Eigen::Vector2d::Zero();  ///< of the cylinder's axis [m]
  Eigen::Vector2d goal_W = Eigen::Vector2d::Zero();
  Eigen::Vector2d lower_W = Eigen::Vector2d::Zero();  ///< the axis stays in this rectangle, which
  Eigen::Vector2d upper_W = Eigen::Vector2d::Zero();  ///< holds start and goal
  double step_m = 0.05;             ///< of the grid; the bounds below are about this far apart
  ClearanceOptions clearance = {};  ///< what is no obstacle: the robot itself, first of all

  std::vector<hardware::FieldError> Validate() const;
};

/// The way on which the robot keeps farthest from everything but the floor, and how far that is.
///
/// The clearance of a place changes by no more than the way between two places, so a grid bounds it
/// everywhere between its points too. Both bounds are certain; negative: the robot does not fit.
struct WidestPath {
  std::vector<Eigen::Vector2d>
      points_W;                     ///< straight from each to the next, start and goal included
  double clearance_at_least_m = 0;  ///< everywhere along these points
  double clearance_at_most_m = 0;   ///< no way within the rectangle has more
};

/// Finds it by a bottleneck search over a grid (Pollack 1960), each grid point's clearance being
/// CollisionOracle::ClearanceOf(cylinder).
///
/// "There is a free path of clearance c" is certain if clearance_at_least_m >= c, "there is none"
/// if clearance_at_most_m < c; between the two, a finer step decides.
/// @throws hardware::ConfigError when the query does not hold
WidestPath FindWidestPath(const CollisionOracle& oracle, const PathQuery& query);

}  // namespace horopter::sim
