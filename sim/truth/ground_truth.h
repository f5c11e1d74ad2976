// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "hardware/types/camera_model.h"
#include "hardware/types/eye.h"
#include "hardware/types/head_angles.h"
#include "hardware/types/pose.h"
#include "hardware/types/time.h"
#include "sim/render/renderer.h"
#include "sim/world/world.h"

namespace horopter::sim {

/// Where one eye is and how it images, without noise or lens.
struct EyeView {
  hardware::Pose X_WC;  ///< optical frame
  hardware::CameraModel camera;
};

/// What one eye would see if it were perfect. Maps have the size of the camera model.
struct EyeTruth {
  EyeView view;
  cv::Mat1f depth;  ///< along the optical z axis at the pixel's centre [m]; +inf = nothing there
  cv::Mat1i ids;    ///< MuJoCo geom id; -1 = nothing there
};

/// All that is true at one instant. For scoring alone: nothing in the stack may see it.
struct GroundTruth {
  hardware::Time t{};
  EyeTruth left;
  EyeTruth right;
  hardware::Pose X_WBase = hardware::Pose::Identity();
  hardware::HeadAngles head;  ///< of the axes themselves, not of their encoders
  std::vector<Contact> contacts;

  const EyeTruth& operator[](hardware::Eye eye) const {
    return eye == hardware::Eye::kLeft ? left : right;
  }
};

/// Renders the truth of the world's present state.
/// @throws hardware::ConfigError when a camera cannot be rendered as it is (see Renderer::Render)
GroundTruth CaptureGroundTruth(const World& world, Renderer& renderer, const EyeView& left,
                               const EyeView& right, const hardware::Pose& X_WBase,
                               const hardware::HeadAngles& head);

}  // namespace horopter::sim
