// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <opencv2/core/types.hpp>
#include <optional>
#include <string>
#include <vector>

#include "scenarios/dataset/dataset_writer.h"
#include "scenarios/format/robot_description.h"
#include "scenarios/render/gaze_list.h"
#include "scenarios/render/scene_setup.h"
#include "sim/camera/camera_profile.h"

namespace horopter::scenarios {

/// A data set to render: one scene, and a head that looks somewhere in every frame.
struct RenderRequest {
  SceneSetup setup;
  RobotDescription robot;
  std::vector<std::string> pairs;  ///< of the robot's cameras; empty: all
  std::optional<cv::Size> size;    ///< in place of the cameras' native one
  sim::CameraProfile profile;
  bool supersample = false;
  std::string gl_backend = "osmesa";
  std::vector<Gaze> gazes;  ///< a frame each
  bool truth = false;       ///< depth, ids, normals, disparity, flow from frame to frame, states
  std::vector<std::string> views;  ///< cameras of the scene that show it as a whole, once
  DatasetOptions files;
  std::map<std::string, std::string> versions;  ///< for the manifest
  std::filesystem::path out;
};

struct RenderHooks {
  /// Called before each frame.
  std::function<void(int done, int all)> progress = [](int, int) {};
  /// Asked between frames; true ends the data set there, incomplete.
  std::function<bool()> interrupted = [] { return false; };
  /// Called with every frame that was written.
  std::function<void(const DatasetFrame&)> frame = [](const DatasetFrame&) {};
};

/// Renders and writes the frames; both eyes, and all pairs, show one instant.
/// @return whether it ran to its end
/// @throws SceneError, sim::RenderError, hardware::ConfigError, ResultsError
bool RenderDataset(const RenderRequest& request, const RenderHooks& hooks = {});

}  // namespace horopter::scenarios
