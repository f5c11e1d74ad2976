// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>
#include <string_view>

#include "hardware/types/stage_times.h"
#include "hardware/types/stereo_frame.h"
#include "vision/disparity/disparity_field.h"

namespace horopter::vision {

/// A method that finds the vector disparity of an unrectified pair.
///
/// Contract: left and right are CV_8UC1 or CV_8UC3 (BGR), of the same size and type, at least 1x1;
/// anything else throws std::invalid_argument that states both sizes or types. Images too small or
/// too plain to match give a field without valid pixels, not an error. The result depends on the
/// two images alone: same images, same bits.
class DisparityEstimator {
 public:
  virtual ~DisparityEstimator() = default;

  /// @param times receives the milliseconds of the method's stages; may be null
  virtual DisparityField Estimate(const cv::Mat& left, const cv::Mat& right,
                                  hardware::StageTimes* times) = 0;
  DisparityField Estimate(const cv::Mat& left, const cv::Mat& right) {
    return Estimate(left, right, nullptr);
  }
  DisparityField Estimate(const hardware::StereoFrame& frame) {
    return Estimate(frame.left.bgr, frame.right.bgr, nullptr);
  }

  virtual std::string_view name() const = 0;
};

}  // namespace horopter::vision
