// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <string>

#include "sim/rooms/scene_document.h"
#include "sim/world/world.h"

namespace horopter::sim {

/// Slides each piece of furniture along the wall that it stands at, by up to 0.3 m, to where it
/// touches nothing: every body of the world itself that does not move and has a name. Each has a
/// random stream of its own.
///
/// Both are changed alike: `world` is what `scene` says.
/// @return by how much each was moved, along W's x and y
std::map<std::string, Eigen::Vector2d> SlideFurniture(SceneDocument& scene, World& world,
                                                      std::uint64_t seed);

}  // namespace horopter::sim
