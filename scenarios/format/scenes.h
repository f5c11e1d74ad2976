// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace horopter::scenarios {

/// The folder of scenes and robots: the environment's HOROPTER_SCENES_DIR, or else the one this
/// program was built with. It need not exist.
std::filesystem::path ScenesDir();

/// Every *.xml below the folder, as scenarios name them ("koala/room.xml"), sorted.
std::vector<std::string> SceneNames(const std::filesystem::path& scenes_dir);

/// Folders of `scenes_dir` that have a robot.yaml, sorted.
std::vector<std::string> RobotNames(const std::filesystem::path& scenes_dir);

/// scenes_dir/<robot>/robot.yaml.
std::filesystem::path RobotFile(const std::filesystem::path& scenes_dir, const std::string& robot);

}  // namespace horopter::scenarios
