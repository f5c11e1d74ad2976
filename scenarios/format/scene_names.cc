// SPDX-License-Identifier: Apache-2.0
#include "scenarios/format/scene_names.h"

#include <algorithm>
#include <pugixml.hpp>

namespace horopter::scenarios {
namespace {

namespace fs = std::filesystem;

constexpr int kDeepestInclude = 16;

/// Walks one file; MuJoCo looks included files up from the folder of the main one.
class Collector {
 public:
  explicit Collector(const fs::path& folder) : folder_(folder) {}

  bool File(const fs::path& path, int depth) {
    pugi::xml_document document;
    if (depth > kDeepestInclude || !document.load_file(path.c_str())) return false;
    return Below(document, depth);
  }

  SceneContents contents;

 private:
  bool Below(const pugi::xml_node& node, int depth) {
    for (const pugi::xml_node& child : node.children()) {
      const std::string tag = child.name();
      const std::string name = child.attribute("name").value();
      if (tag == "include" && !File(folder_ / child.attribute("file").value(), depth + 1)) {
        return false;
      }
      if (tag == "body" && !name.empty()) contents.bodies.push_back(name);
      if (tag == "camera" && !name.empty()) contents.cameras.push_back(name);
      if (!Below(child, depth)) return false;
    }
    return true;
  }

  fs::path folder_;
};

bool Has(const std::vector<std::string>& sorted, const std::string& name) {
  return std::binary_search(sorted.begin(), sorted.end(), name);
}

}  // namespace

bool SceneContents::HasBody(const std::string& name) const { return Has(bodies, name); }
bool SceneContents::HasCamera(const std::string& name) const { return Has(cameras, name); }

std::optional<SceneContents> ReadSceneContents(const fs::path& mjcf) {
  Collector collector(mjcf.parent_path());
  if (!collector.File(mjcf, 0)) return std::nullopt;
  std::sort(collector.contents.bodies.begin(), collector.contents.bodies.end());
  std::sort(collector.contents.cameras.begin(), collector.contents.cameras.end());
  return std::move(collector.contents);
}

}  // namespace horopter::scenarios
