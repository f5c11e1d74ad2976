// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "scenarios/dataset/dataset_writer.h"
#include "scenarios/render/render_request.h"

namespace horopter::scenarios {

/// What a data set's manifest says of its making.
struct DatasetManifest {
  std::string name;              ///< of the file, for messages
  std::filesystem::path folder;  ///< that it lies in, the data set's own unless it was moved
  RenderRequest request;
  std::string command;
  std::string gl_renderer;
  std::map<std::string, std::string> versions;
  SceneHashes scene_sha256;                   ///< empty in sets of versions that did not say it
  std::map<std::string, std::string> images;  ///< SHA-256 by relative path
  /// Likewise of the tables and of every frame's SHA256SUMS; empty in sets of versions that did not
  /// say it, and in incomplete ones.
  std::map<std::string, std::string> files;
};

/// @param path of a manifest.json, or of the folder that holds it
/// @throws FormatError when it is no manifest with a request; ScenarioError when the request does
///         not hold, or the file cannot be read
DatasetManifest ReadManifest(const std::filesystem::path& path);

/// Which files of the scene are not as they were when the data set was made; empty when all are, or
/// when the manifest does not say.
std::string WhatChangedSince(const DatasetManifest& before);

/// Why a data set made again is not the one before. Compared are the images by their hashes in the
/// manifests; the tables and every frame's SHA256SUMS, which stands for all files of a frame, truth
/// too, by their bytes where they lie beside both manifests, else by their hashes; and the hashes
/// of the scene. Says how many images differ or are missing, which other file is the first that
/// does, and, when anything does, what else is different about the making. Empty when all is the
/// same.
std::string WhatDiffers(const DatasetManifest& before, const DatasetManifest& again);

}  // namespace horopter::scenarios
