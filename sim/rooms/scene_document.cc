// SPDX-License-Identifier: Apache-2.0
#include "sim/rooms/scene_document.h"

#include <fmt/format.h>

#include <cmath>
#include <sstream>

#include "sim/world/world.h"

namespace horopter::sim {
namespace {

void Load(pugi::xml_document& document, const std::filesystem::path& file) {
  const pugi::xml_parse_result read = document.load_file(file.c_str());
  if (!read) {
    throw SceneError(
        fmt::format("scene '{}': {} (at byte {})", file.string(), read.description(), read.offset));
  }
  if (!document.child("mujoco")) {
    throw SceneError(fmt::format("scene '{}' is no MJCF: it has no <mujoco>", file.string()));
  }
}

}  // namespace

SceneDocument::SceneDocument(const std::filesystem::path& scene) {
  Load(document_, scene);
  Expand(root(), scene.parent_path(), 0);
}

void SceneDocument::Expand(pugi::xml_node node, const std::filesystem::path& folder, int depth) {
  constexpr int kDeepest = 16;
  if (depth > kDeepest) throw SceneError("scene includes itself: " + folder.string());
  for (pugi::xml_node child = node.first_child(); child;) {
    const pugi::xml_node next = child.next_sibling();
    if (std::string_view(child.name()) == "include") {
      pugi::xml_document included;
      const std::filesystem::path file = folder / child.attribute("file").value();
      Load(included, file);
      Expand(included.child("mujoco"), file.parent_path(), depth + 1);
      for (const pugi::xml_node part : included.child("mujoco")) {
        node.insert_copy_before(part, child);
      }
      node.remove_child(child);
    } else {
      Expand(child, folder, depth);
    }
    child = next;
  }
}

std::vector<pugi::xml_node> SceneDocument::Elements(std::string_view name) {
  struct Walker : pugi::xml_tree_walker {
    bool for_each(pugi::xml_node& node) override {
      if (node.name() == name) found.push_back(node);
      return true;
    }
    std::string_view name;
    std::vector<pugi::xml_node> found;
  } walker;
  walker.name = name;
  document_.traverse(walker);
  return walker.found;
}

pugi::xml_node SceneDocument::Find(std::string_view element, std::string_view name) {
  for (const pugi::xml_node node : Elements(element)) {
    if (node.attribute("name").value() == name) return node;
  }
  return {};
}

std::string SceneDocument::Text() const {
  std::ostringstream text;
  document_.save(text, "  ");
  return text.str();
}

void SetPose(pugi::xml_node body, const hardware::Pose2& X_WB) {
  const auto set = [&body](const char* name, const std::string& value) {
    pugi::xml_attribute attribute = body.attribute(name);
    if (!attribute) attribute = body.append_attribute(name);
    attribute.set_value(value.c_str());
  };
  const double half_turn = X_WB.heading_rad / 2;
  set("pos", MjcfNumbers({X_WB.x_m, X_WB.y_m, 0}));
  set("quat", MjcfNumbers({std::cos(half_turn), 0, 0, std::sin(half_turn)}));
}

std::string MjcfNumbers(std::initializer_list<double> numbers) {
  return fmt::format("{}", fmt::join(numbers, " "));
}

}  // namespace horopter::sim
