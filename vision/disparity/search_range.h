// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "hardware/types/config_error.h"
#include "vision/disparity/disparity_field.h"

namespace horopter::vision {

/// The disparities x_left - x_right that a method for rectified pairs tries: the sign of
/// Middlebury's disparities, opposite to a DisparityField's dx.
struct SearchRange {
  int min_px = 0;
  int count_px = 128;  ///< a multiple of 16, as OpenCV asks

  /// The least range that holds min_px and what is below end_px.
  static SearchRange Covering(int min_px, int end_px);

  /// Every field that does not hold.
  std::vector<hardware::FieldError> Validate() const;

  /// Columns at the left and right border of the left image whose matches may lie beyond the right
  /// image, which is why OpenCV does not match them.
  int UnmatchedColumns() const;
};

/// A field with dy = 0 of what cv::StereoMatcher computes.
/// @param disparity_16 16 times x_left - x_right in px; below 16 * range.min_px: none
/// @param textured 255 where a match counts
DisparityField FieldOfDisparity(const cv::Mat1s& disparity_16, const SearchRange& range,
                                const cv::Mat1b& textured);

}  // namespace horopter::vision
