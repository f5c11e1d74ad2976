// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <opencv2/core/mat.hpp>

#include "hardware/types/camera_model.h"
#include "hardware/types/eye.h"
#include "hardware/types/pose.h"
#include "sim/truth/scene_snapshot.h"
#include "sim/truth/world_state.h"

namespace horopter::sim {

/// Where one eye is and how it images, lens distortion and all; without noise.
struct EyeView {
  hardware::Pose X_WC;  ///< optical frame
  hardware::CameraModel camera;
  double near_m = 0.03;  ///< depth below which nothing is seen, as RendererOptions has it
  double far_m = 200;    ///< depth beyond which nothing is seen
};

/// What one eye would see if it were perfect: along the ray of each pixel's centre, through the
/// lens as it is. Maps have the size of the camera model.
struct EyeTruth {
  EyeView view;
  cv::Mat1f depth;    ///< along the optical z axis [m]; +inf = nothing there
  cv::Mat1i ids;      ///< part: MuJoCo geom id; -1 = nothing there. SceneLegend names them
  cv::Mat3f normals;  ///< of the true solid, outward, unit, in the optical frame; NaN = nothing
};

/// All that is true at one instant. For scoring alone: nothing in the stack may see it.
struct GroundTruth {
  WorldState state;
  EyeTruth left;
  EyeTruth right;

  const EyeTruth& operator[](hardware::Eye eye) const {
    return eye == hardware::Eye::kLeft ? left : right;
  }
};

/// Casts one ray per pixel: any camera model that has rays, on as many threads as OpenCV has, the
/// same bits on any number. A pixel without a ray (beyond the distortion's fold) sees nothing.
EyeTruth CaptureEyeTruth(const SceneSnapshot& scene, const EyeView& view);

/// The truth of the world's present state.
/// @param shapes of the world's model
GroundTruth CaptureGroundTruth(const World& world, std::shared_ptr<const SceneShapes> shapes,
                               const EyeView& left, const EyeView& right);

}  // namespace horopter::sim
