// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "scenarios/dataset/dataset_writer.h"
#include "scenarios/render/render_request.h"

namespace horopter::scenarios {

/// SHA-256 of every file that the request's scene is made of, by its path below the scenes folder:
/// the scene, what it includes, the pictures and meshes they name, and the robot's robot.yaml. What
/// is not there is left out.
std::map<std::string, std::string> HashSceneFiles(const RenderRequest& request);

/// A scene in one text: every include replaced by what it holds, comments and layout left out.
/// @throws FormatError when a file is no XML or includes go round in circles
std::string ResolveScene(const std::filesystem::path& mjcf);

/// All that a manifest says of the scene that was rendered.
/// @param mjcf text of the scene, resolved
/// @param model as it was rendered, its textures painted
SceneHashes HashScene(const RenderRequest& request, const std::string& mjcf, const mjModel& model);

/// Names of the files that have changed, come or gone from one list to another, each with what
/// happened to it; empty when both are the same.
std::vector<std::string> ChangedFiles(const std::map<std::string, std::string>& before,
                                      const std::map<std::string, std::string>& now);

}  // namespace horopter::scenarios
