// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "hardware/types/pose.h"
#include "scenarios/render/render_request.h"
#include "sim/rooms/room.h"
#include "sim/world/world.h"

namespace horopter::scenarios {

/// A scene to look at.
struct Scenery {
  std::unique_ptr<sim::World> world;
  std::optional<sim::Room> room;  ///< when it was generated
  hardware::Pose X_WO;            ///< the robot's starting frame
};

/// Loads the request's scene and varies it by the seed: a generated room when one is asked for,
/// else a tabletop's objects where there is a table, else what a scenario's seed varies.
/// @throws SceneError, hardware::ConfigError
Scenery LoadScene(const RenderRequest& request);

/// Puts bodies where they are asked to be. @throws SceneError when one is not there, or moves
void PlaceBodies(Scenery& scenery, const std::map<std::string, BodyPlacement>& bodies);

}  // namespace horopter::scenarios
