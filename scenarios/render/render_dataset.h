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
  /// Called with a line about what did not come as it was asked for.
  std::function<void(const std::string&)> note = [](const std::string&) {};
  /// Called with every frame that was written.
  std::function<void(const DatasetFrame&)> frame = [](const DatasetFrame&) {};
};

/// Renders and writes the frames. Still views: both eyes, and all pairs, show one instant, and time
/// stands still. A motion: a frame for each that the cameras deliver (Film), truth of the instant
/// each image was taken at, which is the middle of its exposure for all rows, whatever the shutter;
/// state tables with or without truth, and two tables for the whole set:
///
///   capture.csv      a row per frame and pair: the cameras' own number; of either eye's image when
///                    it was taken (the middle of its exposure) and when its first and last row
///                    were (the middles of theirs; of an interlaced image its first and last
///                    field); when the pair came
///   trajectory.csv   a row per physics step: StateLog
///
/// Besides what DatasetWriter writes there is a PNG for each of the request's views, at the start,
/// and of a generated room room.json (what stands where) and room.xml (the scene). What is wrong
/// with the request is said before anything is written.
/// @return whether it ran to its end
/// @throws SceneError, sim::RenderError, sim::PhysicsError, hardware::ConfigError, ResultsError
bool RenderDataset(const RenderRequest& request, const RenderOutput& output,
                   const RenderHooks& hooks = {});

}  // namespace horopter::scenarios
