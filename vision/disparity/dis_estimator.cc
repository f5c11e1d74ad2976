// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/dis_estimator.h"

#include <stdexcept>
#include <string>

#include "hardware/types/field_checker.h"
#include "vision/disparity/dense_flow.h"

namespace horopter::vision {
std::vector<hardware::FieldError> DisConfig::Validate() const {
  hardware::FieldChecker check("dis.");
  check.Require(preset >= 0 && preset <= 2, "preset", preset, "must be 0, 1 or 2");
  check.NotNegative("left_right_px", left_right_px);
  check.Part(texture.Validate());
  return check.Take();
}

DisConfig DisConfig::Preset(std::string_view name) {
  constexpr std::string_view kUnchecked = "_unchecked";
  const bool checked = !name.ends_with(kUnchecked);
  const std::string_view kind = checked ? name : name.substr(0, name.size() - kUnchecked.size());
  DisConfig config;
  if (kind == "medium") {
    config.preset = cv::DISOpticalFlow::PRESET_MEDIUM;
  } else if (kind == "fast") {
    config.preset = cv::DISOpticalFlow::PRESET_FAST;
  } else if (kind == "ultrafast") {
    config.preset = cv::DISOpticalFlow::PRESET_ULTRAFAST;
  } else {
    throw std::invalid_argument("unknown dis preset \"" + std::string(name) +
                                "\": known are medium, fast, ultrafast, and each with _unchecked");
  }
  if (!checked) config.left_right_px = 0;
  return config;
}

DisEstimator::DisEstimator(const DisConfig& config) : config_(config) {
  hardware::ThrowIfAny(config.Validate());
}

DisparityField DisEstimator::Estimate(const cv::Mat& left, const cv::Mat& right,
                                      hardware::StageTimes* times) {
  const auto flow = [this](const cv::Mat1b& from, const cv::Mat1b& to) {
    cv::Mat2f vectors;
    cv::DISOpticalFlow::create(config_.preset)->calc(from, to, vectors);
    return vectors;
  };
  return DisparityByFlow(left, right, flow, config_.texture, config_.left_right_px, times);
}

}  // namespace horopter::vision
