// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/dis_estimator.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <string>

#include "hardware/types/field_checker.h"
#include "vision/disparity/image_pair.h"
#include "vision/disparity/left_right_check.h"

namespace horopter::vision {
namespace {

constexpr int kSmallestSide = 16;  // below, cv::DISOpticalFlow throws or has no octave to start at

/// 255 where the grey levels around a pixel deviate by at least `min_grey`.
cv::Mat1b Textured(const cv::Mat1b& grey, int window_px, double min_grey) {
  cv::Mat1f value, mean, mean_square;
  grey.convertTo(value, CV_32F);
  const cv::Size window(window_px, window_px);
  cv::boxFilter(value, mean, CV_32F, window);
  cv::sqrBoxFilter(value, mean_square, CV_32F, window);
  return mean_square - mean.mul(mean) >= min_grey * min_grey;
}

/// cv::DISOpticalFlow does not take a part of a larger image.
cv::Mat1b Continuous(const cv::Mat1b& grey) { return grey.isContinuous() ? grey : grey.clone(); }

}  // namespace

std::vector<hardware::FieldError> DisConfig::Validate() const {
  hardware::FieldChecker check("dis.");
  check.Require(preset >= 0 && preset <= 2, "preset", preset, "must be 0, 1 or 2");
  check.NotNegative("left_right_px", left_right_px);
  check.NotNegative("min_contrast_grey", min_contrast_grey);
  check.Require(contrast_window_px >= 3 && contrast_window_px % 2 == 1, "contrast_window_px",
                contrast_window_px, "must be odd and at least 3");
  return check.Take();
}

DisConfig DisConfig::Preset(std::string_view name) {
  DisConfig config;
  if (name == "medium") {
    config.preset = cv::DISOpticalFlow::PRESET_MEDIUM;
  } else if (name == "fast") {
    config.preset = cv::DISOpticalFlow::PRESET_FAST;
  } else if (name == "ultrafast") {
    config.preset = cv::DISOpticalFlow::PRESET_ULTRAFAST;
  } else {
    throw std::invalid_argument("unknown dis preset \"" + std::string(name) +
                                "\": known are medium, fast, ultrafast");
  }
  return config;
}

DisEstimator::DisEstimator(const DisConfig& config) : config_(config) {
  hardware::ThrowIfAny(config.Validate());
}

DisparityField DisEstimator::Estimate(const cv::Mat& left, const cv::Mat& right) {
  CheckPair(left, right);
  const cv::Mat1b left_grey = ToGrey(left);
  const cv::Mat1b right_grey = ToGrey(right);
  DisparityField field = Flow(left_grey, right_grey);
  if (config_.left_right_px > 0) {
    CheckLeftRight(Flow(right_grey, left_grey), config_.left_right_px, field);
  }
  BlankInvalid(field);
  return field;
}

DisparityField DisEstimator::Flow(const cv::Mat1b& from, const cv::Mat1b& to) const {
  const cv::Size size = from.size();
  DisparityField field{cv::Mat1f::zeros(size), cv::Mat1f::zeros(size), cv::Mat1f::ones(size),
                       cv::Mat1b::zeros(size)};
  if (std::min(size.width, size.height) < kSmallestSide) return field;

  cv::Mat2f flow;
  cv::DISOpticalFlow::create(config_.preset)->calc(Continuous(from), Continuous(to), flow);
  cv::extractChannel(flow, field.dx, 0);
  cv::extractChannel(flow, field.dy, 1);
  field.valid = Textured(from, config_.contrast_window_px, config_.min_contrast_grey);
  InvalidateOutside(field);
  return field;
}

}  // namespace horopter::vision
