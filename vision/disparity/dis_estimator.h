// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/video/tracking.hpp>
#include <string_view>
#include <vector>

#include "hardware/types/config_error.h"
#include "vision/disparity/disparity_estimator.h"
#include "vision/disparity/texture_check.h"

namespace horopter::vision {

/// Parameters of OpenCV's dense inverse search.
struct DisConfig {
  /// cv::DISOpticalFlow preset: 0 ultrafast, 1 fast, 2 medium.
  int preset = cv::DISOpticalFlow::PRESET_MEDIUM;
  /// Largest distance between a pixel and where its match points back to [px]; 0 = no check.
  double left_right_px = 1;
  TextureCheck texture;

  /// Every field that does not hold.
  std::vector<hardware::FieldError> Validate() const;

  /// "medium", "fast" or "ultrafast"; with "_unchecked" behind it one way only, without the
  /// left-right check.
  /// @throws std::invalid_argument that lists the known names.
  static DisConfig Preset(std::string_view name);
};

/// The peer: OpenCV's DIS optical flow (Kroeger et al., ECCV 2016) from left to right.
///
/// Invalid and confidence as DisparityByFlow() says: DIS itself fills every pixel and reports none.
class DisEstimator final : public DisparityEstimator {
 public:
  /// @throws ConfigError naming every bad field.
  explicit DisEstimator(const DisConfig& config);

  using DisparityEstimator::Estimate;
  DisparityField Estimate(const cv::Mat& left, const cv::Mat& right,
                          hardware::StageTimes* times) override;
  std::string_view name() const override { return "dis"; }

 private:
  DisConfig config_;
};

}  // namespace horopter::vision
