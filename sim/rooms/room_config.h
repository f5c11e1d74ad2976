// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

#include "hardware/types/config_error.h"

namespace horopter::sim {

/// What kind of room to generate. Every aspect is drawn from a random stream of its own, so that
/// asking for another kind of one changes none of the others.
struct RoomConfig {
  /// The room without obstacles: walls, floor, furniture, lights and a robot with a body "base". In
  /// it nothing may be named obstacle_*.
  std::filesystem::path scene;

  /// How many things stand about, at least and at most; a barrier comes on top.
  int min_obstacles = 4;
  int max_obstacles = 9;

  /// False: a barrier from wall to wall lies between the robot and the first goal, and no way leads
  /// round it.
  bool free_path = true;
  /// The free path keeps the circle round the robot this far from everything that it could hit [m].
  double clearance_m = 0.35;

  /// Places that the robot is to reach one after the other, in its starting frame O [m].
  std::vector<Eigen::Vector2d> goals_m;
  /// By how much O is turned from where the scene has the robot, counter-clockwise.
  double start_turn_rad = 0;

  /// "varied", "as_built" (as the scene has them), or one of LightingNames().
  std::string lighting = "varied";
  bool vary_surfaces = true;   ///< floor, walls, fabrics; false: as the scene has them
  bool vary_furniture = true;  ///< slides along its wall; false: as the scene has it

  std::vector<hardware::FieldError> Validate() const;
};

}  // namespace horopter::sim
