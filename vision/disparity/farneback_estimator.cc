// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/farneback_estimator.h"

#include <opencv2/video/tracking.hpp>
#include <stdexcept>
#include <string>

#include "hardware/types/field_checker.h"
#include "vision/disparity/dense_flow.h"

namespace horopter::vision {

std::vector<hardware::FieldError> FarnebackConfig::Validate() const {
  hardware::FieldChecker check("farneback.");
  check.Require(pyramid_scale >= 0.1 && pyramid_scale <= 0.9, "pyramid_scale", pyramid_scale,
                "must be 0.1 to 0.9");
  check.Require(levels >= 1 && levels <= 20, "levels", levels, "must be 1 to 20");
  check.Require(window_px >= 3 && window_px <= 255, "window_px", window_px, "must be 3 to 255");
  check.Require(iterations >= 1 && iterations <= 100, "iterations", iterations, "must be 1 to 100");
  check.Require(polynomial_px >= 3 && polynomial_px <= 15 && polynomial_px % 2 == 1,
                "polynomial_px", polynomial_px, "must be odd, 3 to 15");
  check.Positive("polynomial_sigma_px", polynomial_sigma_px);
  check.NotNegative("left_right_px", left_right_px);
  check.Part(texture.Validate());
  return check.Take();
}

FarnebackConfig FarnebackConfig::Preset(std::string_view name) {
  FarnebackConfig config;
  if (name == "standard") return config;
  if (name == "gaussian") {
    config.gaussian_window = true;
    return config;
  }
  if (name == "fast") {
    config.polynomial_px = 5;
    config.polynomial_sigma_px = 1.1;
    config.iterations = 1;
    return config;
  }
  throw std::invalid_argument("unknown farneback preset \"" + std::string(name) +
                              "\": known are standard, fast, gaussian");
}

FarnebackEstimator::FarnebackEstimator(const FarnebackConfig& config) : config_(config) {
  hardware::ThrowIfAny(config.Validate());
}

DisparityField FarnebackEstimator::Estimate(const cv::Mat& left, const cv::Mat& right,
                                            hardware::StageTimes* times) {
  const FarnebackConfig& c = config_;
  const auto flow = [&c](const cv::Mat1b& from, const cv::Mat1b& to) {
    cv::Mat2f vectors;
    cv::calcOpticalFlowFarneback(from, to, vectors, c.pyramid_scale, c.levels, c.window_px,
                                 c.iterations, c.polynomial_px, c.polynomial_sigma_px,
                                 c.gaussian_window ? cv::OPTFLOW_FARNEBACK_GAUSSIAN : 0);
    return vectors;
  };
  return DisparityByFlow(left, right, flow, c.texture, c.left_right_px, times);
}

}  // namespace horopter::vision
