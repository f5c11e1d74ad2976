// SPDX-License-Identifier: Apache-2.0
#include "scenarios/format/scenes.h"

#include <algorithm>
#include <cstdlib>

namespace horopter::scenarios {

namespace fs = std::filesystem;

fs::path ScenesDir() {
  const char* chosen = std::getenv("HOROPTER_SCENES_DIR");
  return chosen != nullptr && *chosen != '\0' ? fs::path(chosen) : fs::path(HOROPTER_SCENES_DIR);
}

std::vector<std::string> SceneNames(const fs::path& scenes_dir) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::recursive_directory_iterator it(scenes_dir, error), end; !error && it != end;
       it.increment(error)) {
    if (it->path().extension() == ".xml" && it->is_regular_file(error)) {
      names.push_back(it->path().lexically_relative(scenes_dir).generic_string());
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<std::string> RobotNames(const fs::path& scenes_dir) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator it(scenes_dir, error), end; !error && it != end;
       it.increment(error)) {
    std::error_code none;
    if (fs::is_regular_file(it->path() / "robot.yaml", none)) {
      names.push_back(it->path().filename().string());
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

fs::path RobotFile(const fs::path& scenes_dir, const std::string& robot) {
  return scenes_dir / robot / "robot.yaml";
}

}  // namespace horopter::scenarios
