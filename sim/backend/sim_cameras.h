// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "hardware/interfaces/camera_pair.h"
#include "hardware/types/camera_model.h"
#include "hardware/types/eye.h"
#include "hardware/types/stage_times.h"
#include "sim/backend/sim_clock.h"
#include "sim/backend/sim_device.h"
#include "sim/camera/camera_profile.h"
#include "sim/camera/sensor_model.h"
#include "sim/render/renderer.h"
#include "sim/world/world.h"

namespace horopter::sim {

/// A pair of simulated cameras: which of the scene's, their optics and their sensor.
///
/// `model` says where points are seen (CameraProfile::lens.Model() makes one); of the profile's
/// lens only blur and vignetting count here.
struct SimCamerasConfig {
  hardware::PerEye<std::string> mjcf_camera{"left", "right"};  ///< names in the scene
  hardware::PerEye<hardware::CameraModel> model;
  CameraProfile profile;
  std::uint64_t seed = 1;
};

/// Two cameras of a scene behind the hardware interface. Both images of a frame are of the same
/// physics state.
class SimCameras final : public SimDevice<hardware::CameraPair> {
 public:
  /// @param world outlives the device, as do `renderer` (at least as large as the images), `clock`
  ///        and `times`
  /// @param times books "render", "read_back" and "sensor" of every eye
  /// @throws SceneError when the scene lacks a camera; hardware::ConfigError
  SimCameras(World& world, Renderer& renderer, SimClock& clock, const SimCamerasConfig& config,
             hardware::StageTimes& times);

  hardware::CameraModel model(hardware::Eye eye) const override { return config_.model[eye]; }
  hardware::Result<hardware::StereoFrame> Grab() override;

 private:
  hardware::EyeImage See(hardware::Eye eye, const hardware::StereoFrame& frame);

  SimCamerasConfig config_;
  World& world_;
  Renderer& renderer_;
  SimClock& clock_;
  hardware::StageTimes& times_;
  SensorModel sensor_[2];
  std::uint64_t sequence_ = 0;
};

}  // namespace horopter::sim
