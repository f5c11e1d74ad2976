// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace horopter::scenarios {

/// What a scene names, without compiling it. Sorted.
struct SceneContents {
  std::vector<std::string> bodies;
  std::vector<std::string> cameras;

  bool HasBody(const std::string& name) const;
  bool HasCamera(const std::string& name) const;
};

/// Reads an MJCF file and what it includes.
/// @return nothing when one of them is no XML: MuJoCo says better what is wrong with it
std::optional<SceneContents> ReadSceneContents(const std::filesystem::path& mjcf);

}  // namespace horopter::scenarios
