// SPDX-License-Identifier: Apache-2.0
#include "scenarios/render/scene_files.h"

#include <pugixml.hpp>
#include <set>
#include <span>
#include <sstream>
#include <string_view>

#include "scenarios/dataset/format_error.h"
#include "scenarios/format/read_text.h"
#include "scenarios/format/scenes.h"
#include "scenarios/results/hasher.h"

namespace horopter::scenarios {
namespace {

namespace fs = std::filesystem;

constexpr int kDeepestInclude = 16;

/// Puts a scene together from its files, and remembers which there were.
class Resolver {
 public:
  explicit Resolver(const fs::path& scene) : folder_(scene.parent_path()) {
    Load(scene, document_);
    Resolve(document_, 0);
    FindAssets(document_);
  }

  const pugi::xml_document& document() const { return document_; }
  const std::set<fs::path>& files() const { return files_; }

 private:
  void Load(const fs::path& file, pugi::xml_document& into) {
    if (!into.load_file(file.c_str())) throw FormatError(file.string() + ": is no XML");
    files_.insert(file);
  }

  /// MuJoCo looks included files up from the folder of the main one.
  void Resolve(pugi::xml_node node, int depth) {
    if (depth > kDeepestInclude) throw FormatError(folder_.string() + ": includes go in circles");
    for (pugi::xml_node child = node.first_child(); child;) {
      const pugi::xml_node next = child.next_sibling();
      if (std::string_view(child.name()) == "include") {
        pugi::xml_document included;
        Load(folder_ / child.attribute("file").value(), included);
        Resolve(included, depth + 1);
        for (const pugi::xml_node& part : included.document_element().children()) {
          node.insert_copy_before(part, child);
        }
        node.remove_child(child);
      } else {
        Resolve(child, depth);
      }
      child = next;
    }
  }

  /// Pictures of textures, and meshes: attributes file, fileright and so on.
  void FindAssets(const pugi::xml_node& node) {
    const pugi::xml_node compiler = document_.document_element().child("compiler");
    for (const pugi::xml_node& child : node.children()) {
      const bool picture = std::string_view(child.name()) == "texture";
      const fs::path below = compiler.attribute(picture ? "texturedir" : "meshdir").value();
      for (const pugi::xml_attribute& attribute : child.attributes()) {
        if (!std::string_view(attribute.name()).starts_with("file")) continue;
        const fs::path file = folder_ / below / attribute.value();
        if (fs::is_regular_file(file)) files_.insert(file);
      }
      FindAssets(child);
    }
  }

  fs::path folder_;
  pugi::xml_document document_;
  std::set<fs::path> files_;
};

std::string Sha256(std::string_view bytes) {
  Hasher hasher;
  hasher.Update(std::as_bytes(std::span(bytes)));
  return hasher.Hex();
}

std::string HashTextures(const mjModel& model) {
  Hasher hasher;
  for (int i = 0; i < model.ntex; ++i) {
    hasher.Update(model.tex_type[i]);
    hasher.Update(model.tex_width[i]);
    hasher.Update(model.tex_height[i]);
  }
  const auto size = static_cast<std::size_t>(model.ntexdata);
  hasher.Update(std::as_bytes(std::span(model.tex_rgb, size)));
  return hasher.Hex();
}

}  // namespace

std::map<std::string, std::string> HashSceneFiles(const RenderRequest& request) {
  const fs::path scenes = ScenesDir();
  std::set<fs::path> files = Resolver(scenes / request.scene).files();
  files.insert(RobotFile(scenes, request.robot));
  std::map<std::string, std::string> hashes;
  for (const fs::path& file : files) {
    if (!fs::is_regular_file(file)) continue;
    const fs::path name = file.lexically_normal().lexically_relative(scenes.lexically_normal());
    hashes[name.generic_string()] = Sha256(ReadText(file));
  }
  return hashes;
}

std::string ResolveScene(const fs::path& mjcf) {
  const Resolver scene(mjcf);
  std::ostringstream text;
  scene.document().save(text, "", pugi::format_raw | pugi::format_no_declaration);
  return text.str();
}

SceneHashes HashScene(const RenderRequest& request, const std::string& mjcf, const mjModel& model) {
  return {Sha256(mjcf), HashTextures(model), HashSceneFiles(request)};
}

std::vector<std::string> ChangedFiles(const std::map<std::string, std::string>& before,
                                      const std::map<std::string, std::string>& now) {
  std::vector<std::string> changed;
  for (const auto& [file, hash] : before) {
    const auto found = now.find(file);
    if (found == now.end()) changed.push_back(file + " (gone)");
    if (found != now.end() && found->second != hash) changed.push_back(file);
  }
  for (const auto& [file, hash] : now) {
    if (before.count(file) == 0) changed.push_back(file + " (new)");
  }
  return changed;
}

}  // namespace horopter::scenarios
