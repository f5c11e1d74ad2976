// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "hardware/interfaces/camera_pair.h"
#include "hardware/types/camera_model.h"
#include "hardware/types/eye.h"
#include "hardware/types/stage_times.h"
#include "sim/backend/pose_history.h"
#include "sim/backend/sim_clock.h"
#include "sim/backend/sim_device.h"
#include "sim/camera/camera_profile.h"
#include "sim/camera/eye_camera.h"
#include "sim/camera/frame_timing.h"
#include "sim/faults/frame_faults.h"
#include "sim/render/renderer.h"
#include "sim/world/world.h"

namespace horopter::sim {

/// A pair of simulated cameras: which of the scene's, their optics and what they do to an image.
///
/// `model` says where points are seen (CameraProfile::lens.Model() makes one); of the profile's
/// lens only blur and vignetting count here.
struct SimCamerasConfig {
  hardware::PerEye<std::string> mjcf_camera{"left", "right"};  ///< names in the scene
  hardware::PerEye<hardware::CameraModel> model;
  CameraProfile profile;
  std::uint64_t seed = 1;
  std::vector<Fault> faults{};  ///< of which dark eyes and lost frames count here

  /// What a renderer must be able to draw for these cameras: RendererOptions' width and height.
  /// @throws hardware::ConfigError when the profile does not hold or no pinhole covers a view
  cv::Size RenderSize() const;
};

/// Two cameras of a scene behind the hardware interface, in lockstep.
///
/// Without a frame rate there is a frame at every physics step, and each Grab() is a new one, of
/// the instant that lies the profile's latency back. With a rate the cameras run freely: Grab()
/// gives the newest frame that has been delivered, and the same one again until the next is there;
/// a repeated frame has a number of its own and the images and capture times of the one before, and
/// so has an eye whose frame is lost. Without a rate only frames that are grabbed can be lost.
///
/// Only frames that are asked for are rendered: the poses of the capture instant are kept until
/// then. Both images are of one physics state unless the profile has skew. Capture times are whole
/// physics steps, in the middle of the exposure; they lie before time zero when a frame was taken
/// while the robot came to rest, and show it at rest. What motion does within one image is stated
/// at LensResampler.
class SimCameras final : public SimDevice<hardware::CameraPair> {
 public:
  /// @param world outlives the device, as do `renderer` (of at least RenderSize()), `clock` and
  ///        `times`
  /// @param times books "render", "read_back" and "sensor" of every eye
  /// @throws SceneError when the scene lacks a camera; hardware::ConfigError
  SimCameras(World& world, Renderer& renderer, SimClock& clock, const SimCamerasConfig& config,
             hardware::StageTimes& times);

  hardware::CameraModel model(hardware::Eye eye) const override { return config_.model[eye]; }
  hardware::Result<hardware::StereoFrame> Grab() override;

  /// Runs `look` with the world as it was when an eye's newest grabbed image was taken (before the
  /// first Grab(): as it is), for truth of that image.
  void AtCapture(hardware::Eye eye, const std::function<void()>& look);

 private:
  /// One frame to be seen: when by each eye, when it came, and which noise it has.
  struct Plan {
    std::uint64_t sequence = 0;
    hardware::PerEye<std::uint64_t> noise;
    hardware::PerEye<hardware::Time> t_capture;
    hardware::Time t_delivered{};
  };
  Plan PlanFrame();
  /// The frame whose exposure an eye shows in a delivered one, at a rate.
  std::uint64_t ShownBy(hardware::Eye eye, std::uint64_t frame) const;
  /// Whether the newest image of an eye is the planned one.
  bool HasSeen(hardware::Eye eye, const Plan& plan) const;
  void Remember();
  /// Whether a frame of the rate is captured now.
  bool CapturedNow(hardware::Time now);
  hardware::EyeImage See(hardware::Eye eye, const Plan& plan);

  SimCamerasConfig config_;
  World& world_;
  Renderer& renderer_;
  SimClock& clock_;
  hardware::StageTimes& times_;
  hardware::PerEye<std::optional<EyeCamera>> eye_;  ///< set from construction on
  PoseHistory history_;
  std::optional<FrameTiming> timing_;  ///< none: a frame for every physics step
  hardware::Duration half_window_;
  /// Without a rate: how far back the captures lie.
  hardware::PerEye<hardware::Duration> lag_;
  std::uint64_t sequence_ = 0;       ///< of the next Grab(), without a rate
  std::uint64_t next_captured_ = 0;  ///< first frame not captured yet, with a rate
  FrameFaults faults_;
  hardware::PerEye<std::optional<hardware::EyeImage>> last_;  ///< what was given out
  hardware::PerEye<std::uint64_t> last_noise_{};              ///< its noise
  hardware::PerEye<std::optional<WorldPoses>> at_capture_;
};

}  // namespace horopter::sim
