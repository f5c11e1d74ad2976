// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>

#include "hardware/types/eye.h"
#include "hardware/types/time.h"

namespace horopter::hardware {

/// One eye's image and the instant it shows (mid-exposure).
struct EyeImage {
  cv::Mat bgr;  ///< CV_8UC3, rows x cols as the camera model of that eye says
  Time t_capture{};
};

/// A pair of images, delivered together. In simulation both show the same instant unless the
/// scenario injects skew.
struct StereoFrame {
  EyeImage left;
  EyeImage right;
  Time t_delivered{};
  std::uint64_t sequence = 0;  ///< counts frames of the camera, dropped ones included

  const EyeImage& operator[](Eye eye) const { return eye == Eye::kLeft ? left : right; }
};

}  // namespace horopter::hardware
