// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "control/navigator/navigator_config.h"
#include "control/navigator/strips.h"

namespace horopter::control {

/// A way round: which side, by how much off the robot's heading, and how far until the next choice.
struct Detour {
  Strip side = Strip::kLeft;
  double turn_rad = 0;  ///< positive to the left
  double distance_m = 0;
};

/// Points of the ground that something stands on, in the base frame [m].
struct KnownGround {
  std::vector<Eigen::Vector2d> seen_B;     ///< all that was seen, mismatches too
  std::vector<Eigen::Vector2d> certain_B;  ///< what counts as being there
};

/// Among the multiples of avoid_angle_rad the direction with the shortest way to the goal.
///
/// A direction is driven for `distance_m`, or as far as it is free: its corridor must be clear of
/// all that was seen, up to where the robot's front is when it has overshot the waypoint by its
/// tolerance; less than avoid_min_m is no way. From there on the way is measured through what is
/// certain, since single mismatches would close every gap that is hardly wider than the robot.
/// Turning counts as what would be driven meanwhile, leaving a held side as avoid_other_side_m.
/// @param p_BG the goal, in the base frame [m]
/// @param distance_m of a waypoint where nothing is in the way
/// @param freer the side to take where both are as good
/// @param held the side of the avoidance under way
/// @return nothing when no direction is free
std::optional<Detour> ShortestDetour(const KnownGround& known, const Eigen::Vector2d& p_BG,
                                     double distance_m, Strip freer, std::optional<Strip> held,
                                     const NavigatorConfig& config);

}  // namespace horopter::control
