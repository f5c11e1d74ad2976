// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

namespace horopter::vision {

/// Octaves of an image, full size first: [1 4 6 4 1]/16 and every second pixel, so that pixel
/// (x, y) of an octave lies on (2x, 2y) of the one before. Borders are replicated.
/// @param scales at most this many, and no octave beyond the first with a side below min_side_px
std::vector<cv::Mat1f> BuildPyramid(const cv::Mat1f& image, int scales, int min_side_px);

/// A disparity component of an octave as the next finer one sees it: twice as large, bilinear.
cv::Mat1f UpsampleDisparity(const cv::Mat1f& coarse, cv::Size fine);

/// Whatever a pixel of an octave carries, for the nearest pixels of the next finer one.
cv::Mat UpsampleNearest(const cv::Mat& coarse, cv::Size fine);

}  // namespace horopter::vision
