// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

#include "sim/rooms/room_config.h"
#include "sim/tabletop/tabletop_config.h"
#include "sim/world/world.h"

namespace horopter::scenarios {

/// A scene to look at.
struct SceneSetup {
  std::filesystem::path scene;
  std::optional<std::uint64_t> seed;    ///< none: the scene as it is written down
  std::optional<sim::RoomConfig> room;  ///< obstacles to generate in it (`scene` is put in)
  sim::TabletopConfig tabletop;         ///< for scenes with objects to put on a table
};

/// Loads the scene and varies it by the seed: a generated room when one is asked for, else a
/// tabletop's objects where there is a table, else what a scenario's seed varies.
/// @throws SceneError, hardware::ConfigError
std::unique_ptr<sim::World> LoadScene(const SceneSetup& setup);

}  // namespace horopter::scenarios
