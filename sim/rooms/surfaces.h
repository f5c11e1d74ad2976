// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "sim/rooms/scene_document.h"

namespace horopter::sim {

/// Lays another floor, builds the brick wall otherwise, and dyes fabrics, stains wood and tints
/// walls, by rewriting the scene's texture recipes and wall materials. Each has a stream of its
/// own.
/// @return the recipes that changed, by their texture
std::map<std::string, std::string> VarySurfaces(SceneDocument& scene, std::uint64_t seed);

}  // namespace horopter::sim
