// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "hardware/types/config_error.h"

namespace horopter::vision {

/// What a method that fills every pixel cannot have seen: the surroundings are plain.
struct TextureCheck {
  /// Deviation of the grey levels of a neighbourhood below which it is textureless: above the
  /// sensor's noise. 0 = no check.
  double min_contrast_grey = 1.5;
  /// Width of that neighbourhood: DIS matches patches of 8 px.
  int window_px = 9;

  /// Every field that does not hold.
  std::vector<hardware::FieldError> Validate() const;

  /// 255 where there is texture.
  cv::Mat1b Apply(const cv::Mat1b& grey) const;
};

}  // namespace horopter::vision
