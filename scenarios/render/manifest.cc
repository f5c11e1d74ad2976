// SPDX-License-Identifier: Apache-2.0
#include "scenarios/render/manifest.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>
#include <sstream>
#include <utility>

#include "scenarios/dataset/format_error.h"
#include "scenarios/format/read_text.h"
#include "scenarios/render/scene_files.h"

namespace horopter::scenarios {
namespace {

namespace fs = std::filesystem;

std::string ImagesThatDiffer(const DatasetManifest& before, const DatasetManifest& again) {
  int different = 0;
  for (const auto& [image, hash] : before.images) {
    const auto found = again.images.find(image);
    if (found == again.images.end() || found->second != hash) ++different;
  }
  if (different == 0 && before.images.size() == again.images.size()) return "";
  if (different == 0) {
    return fmt::format("there are {} images, {} in {}", again.images.size(), before.images.size(),
                       before.name);
  }
  return fmt::format("{} of {} images are not those of {}", different, before.images.size(),
                     before.name);
}

/// SHA-256 by file, of a list as sha256sum writes it.
std::map<std::string, std::string> ReadSums(const fs::path& file) {
  std::map<std::string, std::string> sums;
  std::istringstream lines(ReadText(file));
  for (std::string hash, name; lines >> hash >> name;) sums[name] = hash;
  return sums;
}

/// The first file of a frame whose hash is another; the list itself when it is only written
/// otherwise.
std::string FirstInLists(const std::string& list, const fs::path& before, const fs::path& again) {
  const fs::path frame = fs::path(list).parent_path();
  const auto was = ReadSums(before / list), is = ReadSums(again / list);
  for (const auto& [file, hash] : was) {
    const auto found = is.find(file);
    if (found == is.end() || found->second != hash) return (frame / file).string();
  }
  for (const auto& [file, hash] : is) {
    if (!was.contains(file)) return (frame / file).string();
  }
  return list;
}

/// Whether a table or a list of hashes is as it was: its bytes, or else the hashes that are kept.
bool IsAsItWas(const std::string& file, const DatasetManifest& before,
               const DatasetManifest& again) {
  const fs::path was = before.folder / file, is = again.folder / file;
  if (fs::is_regular_file(was) && fs::is_regular_file(is)) return ReadText(was) == ReadText(is);
  if (before.files.empty()) return true;  // nobody says how it was
  const auto hash = before.files.find(file), now = again.files.find(file);
  return hash != before.files.end() && now != again.files.end() && hash->second == now->second;
}

std::string FirstFileThatDiffers(const DatasetManifest& before, const DatasetManifest& again) {
  auto files = again.files;
  files.insert(before.files.begin(), before.files.end());
  for (const auto& [file, hash] : files) {
    if (IsAsItWas(file, before, again)) continue;
    const bool both =
        fs::is_regular_file(before.folder / file) && fs::is_regular_file(again.folder / file);
    const bool is_list = fs::path(file).filename() == "SHA256SUMS";
    const std::string first =
        both && is_list ? FirstInLists(file, before.folder, again.folder) : file;
    return fmt::format("{} is not that of {}", first, before.name);
  }
  return "";
}

std::string SceneThatDiffers(const SceneHashes& was, const SceneHashes& is) {
  std::vector<std::string> what;
  if (!was.mjcf.empty() && was.mjcf != is.mjcf) {
    const auto changed = ChangedFiles(was.files, is.files);
    what.push_back(changed.empty()
                       ? std::string("the scene is another, though of the same files")
                       : fmt::format("the scene is another: {}", fmt::join(changed, ", ")));
  }
  if (!was.textures.empty() && was.textures != is.textures) {
    what.emplace_back("its textures are others");
  }
  return fmt::format("{}", fmt::join(what, "; "));
}

}  // namespace

DatasetManifest ReadManifest(const std::filesystem::path& path) {
  const auto file = std::filesystem::is_directory(path) ? path / "manifest.json" : path;
  DatasetManifest manifest;
  manifest.name = file.string();
  manifest.folder = file.parent_path();
  try {
    const auto json = nlohmann::json::parse(ReadText(file));
    if (json.at("format_version") != 2) {
      throw FormatError(manifest.name +
                        ": holds no request: it was made by an older version; render it anew");
    }
    json.at("command").get_to(manifest.command);
    json.at("gl_renderer").get_to(manifest.gl_renderer);
    json.at("versions").get_to(manifest.versions);
    json.at("images").get_to(manifest.images);
    if (json.contains("files")) json.at("files").get_to(manifest.files);
    if (json.contains("scene_sha256")) {
      const auto& scene = json.at("scene_sha256");
      scene.at("mjcf").get_to(manifest.scene_sha256.mjcf);
      scene.at("textures").get_to(manifest.scene_sha256.textures);
      scene.at("files").get_to(manifest.scene_sha256.files);
    }
    manifest.request = DecodeRequest(json.at("request").dump(), manifest.name + ": request");
  } catch (const nlohmann::json::exception& error) {
    throw FormatError(manifest.name + ": is no manifest of a data set: " + error.what());
  }
  return manifest;
}

std::string WhatChangedSince(const DatasetManifest& before) {
  const auto& files = before.scene_sha256.files;
  if (files.empty()) return "";
  const auto changed = ChangedFiles(files, HashSceneFiles(before.request));
  if (changed.empty()) return "";
  return fmt::format("the scene has changed since {} was made: {}", before.name,
                     fmt::join(changed, ", "));
}

std::string WhatDiffers(const DatasetManifest& before, const DatasetManifest& again) {
  std::vector<std::string> what;
  for (std::string difference :
       {ImagesThatDiffer(before, again), FirstFileThatDiffers(before, again),
        SceneThatDiffers(before.scene_sha256, again.scene_sha256)}) {
    if (!difference.empty()) what.push_back(std::move(difference));
  }
  if (what.empty()) return "";
  if (before.gl_renderer != again.gl_renderer) {
    what.push_back(fmt::format("GL was '{}', is '{}'", before.gl_renderer, again.gl_renderer));
  }
  for (const auto& [library, version] : before.versions) {
    const auto found = again.versions.find(library);
    const std::string now = found == again.versions.end() ? "not there" : found->second;
    if (now != version) what.push_back(fmt::format("{} was {}, is {}", library, version, now));
  }
  return fmt::format("{}", fmt::join(what, "; "));
}

}  // namespace horopter::scenarios
