// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>

#include "sim/world/world.h"

namespace horopter::sim {

inline std::filesystem::path YorickScenes() {
  return std::filesystem::path(HOROPTER_SOURCE_DIR) / "scenes/yorick";
}

/// The shipped tabletop without its textures' recipes, whose painting takes most of the time.
inline std::unique_ptr<World> UnpaintedTabletop() {
  auto world = std::make_unique<World>(YorickScenes() / "tabletop.xml");
  world->mutable_model().ntext = 0;
  return world;
}

}  // namespace horopter::sim
