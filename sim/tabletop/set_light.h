// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "sim/tabletop/tabletop_config.h"
#include "sim/world/world.h"

namespace horopter::sim {

/// What a LightConfig came to with a seed.
struct LampState {
  double azimuth_rad = 0;
  double elevation_rad = 0;
  double brightness = 1;
  double colour_temperature_k = 6500;
};

/// Draws each value from a random stream of its own.
LampState DrawLamp(const LightConfig& config, std::uint64_t seed);

/// Puts the directional light "lamp" where `lamp` says, seen from `centre_W`, and scales and tints
/// all lights of a world that has just been loaded. Takes effect with World::Forward().
/// @throws SceneError when the scene has no light of that name
void SetLamp(World& world, const LampState& lamp, const Eigen::Vector3d& centre_W);

}  // namespace horopter::sim
