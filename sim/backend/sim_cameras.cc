// SPDX-License-Identifier: Apache-2.0
#include "sim/backend/sim_cameras.h"

namespace horopter::sim {

using hardware::Eye;

SimCameras::SimCameras(World& world, Renderer& renderer, SimClock& clock,
                       const SimCamerasConfig& config, hardware::StageTimes& times)
    : config_(config),
      world_(world),
      renderer_(renderer),
      clock_(clock),
      times_(times),
      sensor_{
          SensorModel(config.profile, config.model.left, config.seed, config.mjcf_camera.left),
          SensorModel(config.profile, config.model.right, config.seed, config.mjcf_camera.right)} {
  for (const Eye eye : hardware::kBothEyes) world.Id(mjOBJ_CAMERA, config.mjcf_camera[eye]);
}

hardware::Result<hardware::StereoFrame> SimCameras::Grab() {
  if (const auto allowed = Require("Grab", false); !allowed.ok()) return allowed.error();
  hardware::StereoFrame frame;
  frame.sequence = sequence_++;
  frame.t_delivered = clock_.Now();
  frame.left = See(Eye::kLeft, frame);
  frame.right = See(Eye::kRight, frame);
  return frame;
}

hardware::EyeImage SimCameras::See(Eye eye, const hardware::StereoFrame& frame) {
  const hardware::Pose X_WC = world_.X_WCamera(config_.mjcf_camera[eye]);
  cv::Mat bgr = renderer_.Render(X_WC, config_.model[eye], {}, &times_).bgr;
  const SensorModel& sensor = eye == Eye::kLeft ? sensor_[0] : sensor_[1];
  times_.Measure("sensor", [&] { sensor.Apply(frame.sequence, bgr); });
  return {bgr, frame.t_delivered};
}

}  // namespace horopter::sim
