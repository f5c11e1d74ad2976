// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/video/tracking.hpp>
#include <string_view>
#include <vector>

#include "hardware/types/config_error.h"
#include "vision/disparity/disparity_estimator.h"

namespace horopter::vision {

/// Parameters of OpenCV's dense inverse search.
struct DisConfig {
  /// cv::DISOpticalFlow preset: 0 ultrafast, 1 fast, 2 medium.
  int preset = cv::DISOpticalFlow::PRESET_MEDIUM;
  /// Largest distance between a pixel and where its match points back to [px]; 0 = no check.
  double left_right_px = 1;
  /// Deviation of the grey levels of a neighbourhood below which it is textureless: above the
  /// sensor's noise.
  double min_contrast_grey = 1.5;
  /// Width of that neighbourhood: DIS matches patches of 8 px.
  int contrast_window_px = 9;

  /// Every field that does not hold.
  std::vector<hardware::FieldError> Validate() const;

  /// "medium", "fast" or "ultrafast".
  /// @throws std::invalid_argument that lists the known names.
  static DisConfig Preset(std::string_view name);
};

/// The peer: OpenCV's DIS optical flow (Kroeger et al., ECCV 2016) from left to right.
///
/// DIS itself fills every pixel; invalid here is what has no texture, leaves the right image, or
/// fails the left-right check. Images with a side under 16 px give no valid pixel. Confidence is 1
/// where valid: DIS does not report any.
class DisEstimator final : public DisparityEstimator {
 public:
  /// @throws ConfigError naming every bad field.
  explicit DisEstimator(const DisConfig& config);

  DisparityField Estimate(const cv::Mat& left, const cv::Mat& right) override;
  std::string_view name() const override { return "dis"; }

 private:
  DisparityField Flow(const cv::Mat1b& from, const cv::Mat1b& to) const;

  DisConfig config_;
};

}  // namespace horopter::vision
