// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/texture_check.h"

#include <opencv2/imgproc.hpp>

#include "hardware/types/field_checker.h"

namespace horopter::vision {

std::vector<hardware::FieldError> TextureCheck::Validate() const {
  hardware::FieldChecker check("texture.");
  check.NotNegative("min_contrast_grey", min_contrast_grey);
  check.Require(window_px >= 3 && window_px % 2 == 1, "window_px", window_px,
                "must be odd and at least 3");
  return check.Take();
}

cv::Mat1b TextureCheck::Apply(const cv::Mat1b& grey) const {
  cv::Mat1f value, mean, mean_square;
  grey.convertTo(value, CV_32F);
  const cv::Size window(window_px, window_px);
  cv::boxFilter(value, mean, CV_32F, window);
  cv::sqrBoxFilter(value, mean_square, CV_32F, window);
  return mean_square - mean.mul(mean) >= min_contrast_grey * min_contrast_grey;
}

}  // namespace horopter::vision
