// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace horopter::scenarios {

/// What a scene names, without compiling it. Sorted.
struct SceneContents {
  std::vector<std::string> bodies;
  std::vector<std::string> cameras;
  std::vector<std::string> geoms;
  std::vector<std::string> static_bodies;  ///< those that ride on no joint
  /// What the plane "floor" covers, along W's x and y [m]; nothing when it has no end, or none is
  /// there.
  std::optional<Eigen::AlignedBox2d> floor;

  bool HasBody(const std::string& name) const;
  bool HasStaticBody(const std::string& name) const;
  bool HasCamera(const std::string& name) const;
  bool HasGeom(const std::string& name) const;
};

/// Reads an MJCF file and what it includes.
/// @return nothing when one of them is no XML: MuJoCo says better what is wrong with it
std::optional<SceneContents> ReadSceneContents(const std::filesystem::path& mjcf);

}  // namespace horopter::scenarios
