// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "hardware/types/pose.h"

namespace horopter::sim {

/// An MJCF scene as a document that can be edited, with everything that it includes in it: its text
/// needs no other file but those of meshes and pictures.
class SceneDocument {
 public:
  /// @throws SceneError when a file is missing or no XML, or includes itself
  explicit SceneDocument(const std::filesystem::path& scene);
  SceneDocument(const SceneDocument& other) { document_.reset(other.document_); }
  SceneDocument& operator=(const SceneDocument&) = delete;

  pugi::xml_node root() { return document_.child("mujoco"); }
  /// A new section at the end of the scene ("asset", "worldbody"); MuJoCo takes any number of each.
  pugi::xml_node AppendSection(const char* name) { return root().append_child(name); }

  /// Every element of that name, anywhere, in document order.
  std::vector<pugi::xml_node> Elements(std::string_view name);
  /// The element with this name attribute, or an empty node.
  pugi::xml_node Find(std::string_view element, std::string_view name);

  std::string Text() const;

 private:
  void Expand(pugi::xml_node node, const std::filesystem::path& folder, int depth);

  pugi::xml_document document_;
};

/// Writes `pos` and `quat` of a body that stands on the floor.
void SetPose(pugi::xml_node body, const hardware::Pose2& X_WB);

/// Numbers as MJCF has them, with the fewest digits that read back as the same bits.
std::string MjcfNumbers(std::initializer_list<double> numbers);

}  // namespace horopter::sim
