// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include "hardware/types/config_error.h"
#include "vision/disparity/disparity_estimator.h"
#include "vision/disparity/texture_check.h"

namespace horopter::vision {

/// Parameters of cv::calcOpticalFlowFarneback.
struct FarnebackConfig {
  /// Size of a level relative to the one below it.
  double pyramid_scale = 0.5;
  /// At most so many levels; OpenCV uses none with a side under 32 px.
  int levels = 6;
  /// Width of the window over which the vectors are averaged.
  int window_px = 15;
  /// A Gaussian window: better at edges, and several times slower, than a box.
  bool gaussian_window = false;
  int iterations = 3;
  /// Neighbourhood of the quadratic polynomials, and the deviation of their weights [px]. OpenCV's
  /// manual pairs 5 with 1.1 and 7 with 1.5.
  int polynomial_px = 7;
  double polynomial_sigma_px = 1.5;
  /// Largest distance between a pixel and where its match points back to [px]; 0 = no check.
  double left_right_px = 1;
  TextureCheck texture;

  /// Every field that does not hold.
  std::vector<hardware::FieldError> Validate() const;

  /// "standard": the defaults. "fast": smaller polynomials, one iteration. "gaussian": a Gaussian
  /// window.
  /// @throws std::invalid_argument that lists the known names.
  static FarnebackConfig Preset(std::string_view name);
};

/// A peer: OpenCV's optical flow by polynomial expansion (Farneback, SCIA 2003) from left to right.
/// Invalid and confidence as DisparityByFlow() says.
class FarnebackEstimator final : public DisparityEstimator {
 public:
  /// @throws ConfigError naming every bad field.
  explicit FarnebackEstimator(const FarnebackConfig& config);

  using DisparityEstimator::Estimate;
  DisparityField Estimate(const cv::Mat& left, const cv::Mat& right,
                          hardware::StageTimes* times) override;
  std::string_view name() const override { return "farneback"; }

 private:
  FarnebackConfig config_;
};

}  // namespace horopter::vision
