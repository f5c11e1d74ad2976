// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "scenarios/format/robot_description.h"
#include "scenarios/render/render_request.h"

namespace horopter::scenarios {

/// A scene that has a floor and a robot on it, and what can be asked of it.
struct SceneListing {
  std::string name;                      ///< e.g. koala/room.xml
  std::vector<std::string> views;        ///< its own cameras
  std::vector<std::string> backgrounds;  ///< of its table; empty without one
};

/// Every scene below the scenes folder that can be rendered; files that others include apart.
std::vector<SceneListing> ListScenes();

/// The robot in the request. @throws hardware::ConfigError when there is none of that name
RobotDescription RobotOf(const RenderRequest& request);

/// @throws hardware::ConfigError when the scene is not there, or only a part of one
void CheckScene(const RenderRequest& request);

/// Holds the request against its scene and robot, before anything is loaded or written.
/// @throws hardware::ConfigError naming the first option that does not apply, and what would
void CheckRequest(const RenderRequest& request, const RobotDescription& robot);

/// Names of the pairs to be rendered: those asked for, or all; in a motion all that are not the
/// cameras of one before with another lens.
std::vector<std::string> PairNames(const RenderRequest& request, const RobotDescription& robot);

/// A camera as the request and the files name it: PAIR_left, or left where it is the only pair.
std::string CameraStem(const RenderRequest& request, const RobotDescription& robot,
                       const std::string& pair, hardware::Eye eye);

}  // namespace horopter::scenarios
