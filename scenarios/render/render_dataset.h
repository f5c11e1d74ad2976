// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>

#include "scenarios/dataset/dataset_writer.h"
#include "scenarios/render/render_request.h"

namespace horopter::scenarios {

/// Where a data set goes, and what its manifest says of its making.
struct RenderOutput {
  std::filesystem::path folder;  ///< to make; must not hold anything
  std::string command;           ///< the command line
  std::map<std::string, std::string> versions;
};

struct RenderHooks {
  /// Called before each frame.
  std::function<void(int done, int all)> progress = [](int, int) {};
  /// Asked between frames; true ends the data set there, incomplete.
  std::function<bool()> interrupted = [] { return false; };
  /// Called with every frame that was written.
  std::function<void(const DatasetFrame&)> frame = [](const DatasetFrame&) {};
};

/// Renders and writes the frames; both eyes, and all pairs, show one instant. Besides what
/// DatasetWriter writes there is a PNG for each of the request's views, and of a generated room
/// room.json (what stands where) and room.xml (the scene). What is wrong with the request is said
/// before anything is written.
/// @return whether it ran to its end
/// @throws SceneError, sim::RenderError, hardware::ConfigError, ResultsError
bool RenderDataset(const RenderRequest& request, const RenderOutput& output,
                   const RenderHooks& hooks = {});

}  // namespace horopter::scenarios
