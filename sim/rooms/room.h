// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "sim/rooms/lighting.h"
#include "sim/rooms/obstacle.h"
#include "sim/rooms/room_config.h"

namespace horopter::sim {

/// A generated room: a scene, and what there is to know of it.
struct Room {
  std::string mjcf;  ///< the whole scene, without includes
  std::vector<Obstacle> obstacles;
  Lighting lighting;
  std::map<std::string, std::string> surfaces;       ///< recipes other than the scene's own
  std::map<std::string, Eigen::Vector2d> furniture;  ///< moved from where the scene has it [m]
  bool free_path = true;
  /// The way from the start over all goals, in W [m]; empty in a blocked room.
  std::vector<Eigen::Vector2d> path;
  double path_length_m = 0;
  double path_clearance_m = 0;  ///< of the circle round the robot, along the path
  int attempts = 1;             ///< layouts drawn until one would do
};

/// Generates a room, the same for the same configuration and seed.
///
/// Obstacles stand at least 0.08 m from each other and from everything else. With `free_path` a
/// path over all goals keeps `clearance_m`, by the collision oracle; the first obstacle stands in
/// the straight way. Without it, screens from wall to wall part the robot from the first goal, and
/// the oracle proves that not even a circle within the robot's outline gets through.
/// @throws hardware::ConfigError when the configuration does not hold, a place lies outside the
///         room, or no layout of this kind is found
/// @throws SceneError when the scene cannot be loaded, has obstacles already, or no "base"
Room GenerateRoom(const RoomConfig& config, std::uint64_t seed);

}  // namespace horopter::sim
