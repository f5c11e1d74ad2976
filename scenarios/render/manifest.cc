// SPDX-License-Identifier: Apache-2.0
#include "scenarios/render/manifest.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "scenarios/dataset/format_error.h"
#include "scenarios/format/read_text.h"
#include "scenarios/render/scene_files.h"

namespace horopter::scenarios {

DatasetManifest ReadManifest(const std::filesystem::path& path) {
  const auto file = std::filesystem::is_directory(path) ? path / "manifest.json" : path;
  DatasetManifest manifest;
  manifest.name = file.string();
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
  int different = 0;
  for (const auto& [image, hash] : before.images) {
    const auto found = again.images.find(image);
    if (found == again.images.end() || found->second != hash) ++different;
  }
  if (different == 0) return "";
  std::string what = fmt::format("{} of {} images are not those of {}", different,
                                 before.images.size(), before.name);
  if (before.gl_renderer != again.gl_renderer) {
    what += fmt::format("; GL was '{}', is '{}'", before.gl_renderer, again.gl_renderer);
  }
  const SceneHashes &was = before.scene_sha256, &is = again.scene_sha256;
  if (!was.mjcf.empty() && was.mjcf != is.mjcf) {
    what += fmt::format("; the scene is another: {}",
                        fmt::join(ChangedFiles(was.files, is.files), ", "));
  }
  if (!was.textures.empty() && was.textures != is.textures) what += "; its textures are others";
  for (const auto& [library, version] : before.versions) {
    const auto found = again.versions.find(library);
    const std::string now = found == again.versions.end() ? "not there" : found->second;
    if (now != version) what += fmt::format("; {} was {}, is {}", library, version, now);
  }
  return what;
}

}  // namespace horopter::scenarios
