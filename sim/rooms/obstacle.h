// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>

#include "hardware/types/pose.h"
#include "sim/rooms/scene_document.h"

namespace horopter::sim {

/// A thing that stands in the way.
struct Obstacle {
  std::string name;   ///< of its body: obstacle_1, obstacle_2, ...
  std::string shape;  ///< carton, cartons (two, one on the other), crate, block, drum, bin, ball,
                      ///< screen
  Eigen::Vector3d size_m = Eigen::Vector3d::Zero();  ///< along its own axes; the lower carton's
                                                     ///< footprint, the height of both
  std::string surface;                               ///< what it is painted with
  Eigen::Vector3d rgb = Eigen::Vector3d::Ones();     ///< by which the paint is multiplied
  hardware::Pose2 X_WO{};  ///< its frame: on the floor, below its middle, z up

  /// Of the circle about its origin that contains it, seen from above [m].
  double radius_m() const;
};

/// Shape and size of obstacle `index` (from 1), each from its own stream. Its place is left open.
/// Heights keep to what eyes 0.3 m above the floor see from a metre away.
Obstacle DrawObstacle(int index, std::uint64_t seed);

/// A screen of a barrier: a board of this length on two feet.
Obstacle DrawScreen(int index, double length_m, std::uint64_t seed);

/// Adds the obstacle with its texture and material to the scene.
void AddObstacle(SceneDocument& scene, const Obstacle& obstacle);

}  // namespace horopter::sim
