// SPDX-License-Identifier: Apache-2.0
#include "scenarios/format/scene_names.h"

#include <algorithm>
#include <iterator>
#include <pugixml.hpp>
#include <sstream>

namespace horopter::scenarios {
namespace {

namespace fs = std::filesystem;

constexpr int kDeepestInclude = 16;

std::vector<double> Numbers(const char* text) {
  std::istringstream in(text);
  return {std::istream_iterator<double>(in), {}};
}

/// What a level plane of the world covers; nothing when it has no end.
std::optional<Eigen::AlignedBox2d> GroundOf(const pugi::xml_node& plane) {
  const auto half = Numbers(plane.attribute("size").value());
  if (half.size() < 2 || half[0] <= 0 || half[1] <= 0) return std::nullopt;
  const auto at = Numbers(plane.attribute("pos").value());
  const Eigen::Vector2d centre =
      at.size() < 2 ? Eigen::Vector2d(0, 0) : Eigen::Vector2d(at[0], at[1]);
  const Eigen::Vector2d reach(half[0], half[1]);
  return Eigen::AlignedBox2d(centre - reach, centre + reach);
}

/// Walks one file; MuJoCo looks included files up from the folder of the main one.
class Collector {
 public:
  explicit Collector(const fs::path& folder) : folder_(folder) {}

  /// @param is_static whether what is included stands still
  bool File(const fs::path& path, int depth, bool is_static) {
    pugi::xml_document document;
    if (depth > kDeepestInclude || !document.load_file(path.c_str())) return false;
    return Below(document, depth, is_static);
  }

  SceneContents contents;

 private:
  bool Below(const pugi::xml_node& node, int depth, bool is_static) {
    is_static = is_static && !node.child("joint") && !node.child("freejoint");
    for (const pugi::xml_node& child : node.children()) {
      const std::string tag = child.name();
      const std::string name = child.attribute("name").value();
      if (tag == "include" &&
          !File(folder_ / child.attribute("file").value(), depth + 1, is_static)) {
        return false;
      }
      if (tag == "body" && !name.empty()) Body(child, is_static);
      if (tag == "camera" && !name.empty()) contents.cameras.push_back(name);
      if (tag == "geom" && !name.empty()) contents.geoms.push_back(name);
      if (tag == "geom" && name == "floor") contents.floor = GroundOf(child);
      if (!Below(child, depth, is_static)) return false;
    }
    return true;
  }

  void Body(const pugi::xml_node& body, bool parent_is_static) {
    contents.bodies.push_back(body.attribute("name").value());
    if (parent_is_static && !body.child("joint") && !body.child("freejoint")) {
      contents.static_bodies.push_back(contents.bodies.back());
    }
  }

  fs::path folder_;
};

bool Has(const std::vector<std::string>& sorted, const std::string& name) {
  return std::binary_search(sorted.begin(), sorted.end(), name);
}

}  // namespace

bool SceneContents::HasBody(const std::string& name) const { return Has(bodies, name); }
bool SceneContents::HasStaticBody(const std::string& name) const {
  return Has(static_bodies, name);
}
bool SceneContents::HasCamera(const std::string& name) const { return Has(cameras, name); }
bool SceneContents::HasGeom(const std::string& name) const { return Has(geoms, name); }

std::optional<SceneContents> ReadSceneContents(const fs::path& mjcf) {
  Collector collector(mjcf.parent_path());
  if (!collector.File(mjcf, 0, true)) return std::nullopt;
  SceneContents& contents = collector.contents;
  for (auto* names :
       {&contents.bodies, &contents.cameras, &contents.geoms, &contents.static_bodies}) {
    std::sort(names->begin(), names->end());
  }
  return std::move(collector.contents);
}

}  // namespace horopter::scenarios
