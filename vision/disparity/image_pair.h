// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>

namespace horopter::vision {

/// Throws std::invalid_argument, stating both sizes and types, unless left and right are as
/// DisparityEstimator's contract asks.
void CheckPair(const cv::Mat& left, const cv::Mat& right);

/// The image's grey levels, 0 to 255. @pre it passed CheckPair.
cv::Mat1b ToGrey(const cv::Mat& image);

}  // namespace horopter::vision
