// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/sgbm_estimator.h"

#include <stdexcept>
#include <string>

#include "hardware/types/field_checker.h"
#include "vision/disparity/image_pair.h"

namespace horopter::vision {
namespace {

/// Two costs of 16 bits for each pixel and disparity at once, in the modes that need them all.
void RequireMemory(const SgbmConfig& config, cv::Size size) {
  constexpr double kMostMb = 4000;
  const bool whole_image =
      config.mode == cv::StereoSGBM::MODE_HH || config.mode == cv::StereoSGBM::MODE_HH4;
  const double needed_mb = 4e-6 * size.width * size.height * config.range.count_px;
  if (!whole_image || needed_mb <= kMostMb) return;
  throw std::invalid_argument("sgbm's modes hh and hh4 take " +
                              std::to_string(static_cast<int>(needed_mb)) + " MB for " +
                              std::to_string(size.width) + "x" + std::to_string(size.height) +
                              ": choose 3way or sgbm, or smaller images");
}

}  // namespace

std::vector<hardware::FieldError> SgbmConfig::Validate() const {
  hardware::FieldChecker check("sgbm.");
  check.Part(range.Validate());
  check.Require(mode >= 0 && mode <= 3, "mode", mode, "must be 0 to 3");
  check.Require(block_px >= 1 && block_px <= 11 && block_px % 2 == 1, "block_px", block_px,
                "must be odd, 1 to 11");
  check.Require(small_step_penalty >= 1, "small_step_penalty", small_step_penalty,
                "must be positive");
  check.Require(large_step_penalty > small_step_penalty && large_step_penalty <= 64,
                "large_step_penalty", large_step_penalty,
                "must be above small_step_penalty and at most 64");
  check.Require(max_derivative_grey >= 1 && max_derivative_grey <= 63, "max_derivative_grey",
                max_derivative_grey, "must be 1 to 63");
  check.Require(uniqueness_percent >= 0 && uniqueness_percent < 100, "uniqueness_percent",
                uniqueness_percent, "must be 0 to 99");
  check.NotNegative("left_right_px", left_right_px);
  check.NotNegative("min_segment_px", min_segment_px);
  check.NotNegative("segment_step_px", segment_step_px);
  check.Part(texture.Validate());
  return check.Take();
}

SgbmConfig SgbmConfig::Preset(std::string_view name) {
  SgbmConfig config;
  if (name == "3way") {
    config.mode = cv::StereoSGBM::MODE_SGBM_3WAY;
  } else if (name == "sgbm") {
    config.mode = cv::StereoSGBM::MODE_SGBM;
  } else if (name == "hh") {
    config.mode = cv::StereoSGBM::MODE_HH;
  } else if (name == "hh4") {
    config.mode = cv::StereoSGBM::MODE_HH4;
  } else if (name == "3way_colour") {
    config.colour = true;
  } else {
    throw std::invalid_argument("unknown sgbm preset \"" + std::string(name) +
                                "\": known are 3way, sgbm, hh, hh4, 3way_colour");
  }
  return config;
}

SgbmEstimator::SgbmEstimator(const SgbmConfig& config) : config_(config) {
  hardware::ThrowIfAny(config.Validate());
}

DisparityField SgbmEstimator::Estimate(const cv::Mat& left, const cv::Mat& right,
                                       hardware::StageTimes* times) {
  CheckPair(left, right);
  const SgbmConfig& c = config_;
  RequireMemory(c, left.size());
  cv::Mat1s disparity_16(left.size(), static_cast<short>(16 * (c.range.min_px - 1)));
  const cv::Mat1b left_grey = ToGrey(left);
  const bool matchable = left.cols > c.range.UnmatchedColumns() + c.block_px;
  if (matchable) {
    const bool colour = c.colour && left.channels() == 3;
    const int per_step = (colour ? 3 : 1) * c.block_px * c.block_px;
    const auto matcher = cv::StereoSGBM::create(
        c.range.min_px, c.range.count_px, c.block_px, c.small_step_penalty * per_step,
        c.large_step_penalty * per_step, c.left_right_px, c.max_derivative_grey,
        c.uniqueness_percent, c.min_segment_px, c.segment_step_px, c.mode);
    hardware::MeasureIf(times, "matching", [&] {
      matcher->compute(colour ? left : left_grey, colour ? right : ToGrey(right), disparity_16);
    });
  }
  return hardware::MeasureIf(times, "checks", [&] {
    return FieldOfDisparity(disparity_16, c.range, c.texture.Apply(left_grey));
  });
}

}  // namespace horopter::vision
