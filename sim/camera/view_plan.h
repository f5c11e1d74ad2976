// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>

#include "hardware/types/camera_model.h"

namespace horopter::sim {

/// Rows of an image: `first`, `first + stride` and so on, all before `end`.
struct RowBand {
  int first = 0;
  int end = 0;
  int stride = 1;

  int count() const { return (end - first + stride - 1) / stride; }
  int row(int i) const { return first + i * stride; }
};

/// A view that a real camera's image needs for some of its rows: what an ideal pinhole camera sees
/// from where the eye was at one instant.
struct ViewPlan {
  RowBand rows;
  double t_s = 0;  ///< the instant, from the one that the image is of
  hardware::CameraModel camera;
  /// Whether its rows are exposed from other places too, so that where a pixel is seen depends on
  /// its depth.
  bool needs_depth = false;
};

/// A view as it was rendered.
struct LensView {
  cv::Mat3b bgr;
  cv::Mat1f depth;  ///< along the optical z axis [m], +inf = nothing there; empty when not needed
};

}  // namespace horopter::sim
