// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <opencv2/core/mat.hpp>

#include "hardware/types/stage_times.h"
#include "vision/disparity/disparity_field.h"
#include "vision/disparity/texture_check.h"

namespace horopter::vision {

/// The optical flow from one grey image to another of the same size, a vector for every pixel.
using DenseFlow = std::function<cv::Mat2f(const cv::Mat1b& from, const cv::Mat1b& to)>;

/// The disparity of a pair by a method that gives every pixel a vector, whether it saw one or not:
/// invalid is what has no texture, leaves the right image, or fails the left-right check.
/// Confidence is 1 where valid. Images with a side under 16 px give no valid pixel.
/// @param left_right_px largest distance between a pixel and where its match points back to;
///        0 = no check, and half the time
/// @throws std::invalid_argument for a pair that DisparityEstimator's contract refuses
DisparityField DisparityByFlow(const cv::Mat& left, const cv::Mat& right, const DenseFlow& flow,
                               const TextureCheck& texture, double left_right_px,
                               hardware::StageTimes* times);

}  // namespace horopter::vision
