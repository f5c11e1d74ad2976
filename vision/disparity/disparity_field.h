// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>

namespace horopter::vision {

/// Vector disparity of every pixel of the left image.
///
/// What the left image shows at (x, y) the right image shows at (x + dx, y + dy): the sign of
/// optical flow from left to right, so that nearer points of a parallel rig have negative dx.
/// All four maps have the size of the left image.
struct DisparityField {
  cv::Mat1f dx;          ///< x_right - x_left [px]; NaN where invalid
  cv::Mat1f dy;          ///< y_right - y_left [px]; NaN where invalid
  cv::Mat1f confidence;  ///< 0 (none) to 1; what it measures is stated by the method
  cv::Mat1b valid;       ///< 255 where dx and dy hold, else 0
  /// 255 where they were not matched but filled in from around; empty where nothing was asked to
  /// be.
  cv::Mat1b filled = {};
};

}  // namespace horopter::vision
