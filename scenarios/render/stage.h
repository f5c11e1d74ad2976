// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

#include "scenarios/dataset/dataset_writer.h"
#include "scenarios/format/robot_description.h"
#include "scenarios/render/frame_truth.h"
#include "scenarios/render/render_request.h"
#include "scenarios/render/scene_setup.h"
#include "sim/camera/eye_camera.h"
#include "sim/render/renderer.h"

namespace horopter::scenarios {

/// A scene before the robot's cameras: what there is to see of it, frame after frame, and what is
/// true of that. Nothing moves while a frame is taken.
class Stage {
 public:
  /// @param request,scenery outlive the stage
  /// @throws hardware::ConfigError, sim::SceneError, sim::RenderError
  Stage(const RenderRequest& request, const RobotDescription& robot, Scenery& scenery);

  std::string gl_renderer() const { return renderer_.gl_renderer(); }

  /// The next frame; all cameras show one instant. Frames are a second apart.
  DatasetFrame See(const PosedView& view);

  /// The scene by one of its own cameras.
  cv::Mat3b Overview(const std::string& mjcf_camera);

 private:
  /// A pair of the robot's cameras, ready to take pictures.
  struct Pair {
    std::string name;  ///< empty where it is the only one
    hardware::PerEye<std::string> mjcf_camera;
    hardware::PerEye<std::unique_ptr<sim::EyeCamera>> camera;
  };
  static std::vector<Pair> MakePairs(const RenderRequest& request, const RobotDescription& robot);
  static sim::RendererOptions OptionsFor(const RenderRequest& request,
                                         const std::vector<Pair>& pairs);
  DatasetPair Photograph(Pair& pair);

  const RenderRequest& request_;
  Scenery& scenery_;
  sim::World& world_;
  std::vector<Pair> pairs_;
  sim::Renderer renderer_;
  std::optional<FrameTruth> truth_;  ///< when it is asked for
  int count_ = 0;
};

}  // namespace horopter::scenarios
