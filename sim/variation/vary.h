// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "sim/world/world.h"

namespace horopter::sim {

/// What a seed varies, as a laboratory would from one day to the next.
struct VariationConfig {
  double obstacle_shift_m = 0.15;  ///< radius of the disc within which an obstacle moves; 0: none
  double heading_rad =
      5 * M_PI / 180;    ///< the start heading turns by up to this, either way; 0: none
  bool textures = true;  ///< painted by the seed; false: as seed 0 paints them
};

/// What was varied, for the run's record.
struct Variation {
  struct Shift {
    std::string body;
    Eigen::Vector2d shift_m;  ///< along W's x and y
  };
  std::vector<Shift> obstacles;
  double heading_rad = 0;  ///< added to the start heading, counter-clockwise
};

/// Varies a world that has just been set up: shifts every body named obstacle_*, turns the free
/// body "base" on the spot, paints all textures; then Forward().
///
/// The same seed gives the same world. Each thing has its own random stream, so that switching one
/// off changes no other. Obstacles are placed in the model's order; a place whose footprint comes
/// within 0.05 m of anything that stands in the room, or within 0.15 m of the robot, is drawn
/// again. An obstacle that already stands too close is varied all the same, never closer.
/// @throws hardware::ConfigError when a field is negative or not finite
/// @throws SceneError when no place is found for an obstacle
Variation Vary(World& world, const VariationConfig& config, std::uint64_t seed);

/// By how much Vary() turns the start heading for this seed [rad], counter-clockwise.
double DrawHeading(const VariationConfig& config, std::uint64_t seed);

}  // namespace horopter::sim
