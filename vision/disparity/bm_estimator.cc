// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/bm_estimator.h"

#include <opencv2/calib3d.hpp>
#include <stdexcept>
#include <string>

#include "hardware/types/field_checker.h"
#include "vision/disparity/image_pair.h"

namespace horopter::vision {

std::vector<hardware::FieldError> BmConfig::Validate() const {
  hardware::FieldChecker check("bm.");
  check.Part(range.Validate());
  check.Require(block_px >= 5 && block_px <= 255 && block_px % 2 == 1, "block_px", block_px,
                "must be odd, 5 to 255");
  check.Require(max_derivative_grey >= 1 && max_derivative_grey <= 63, "max_derivative_grey",
                max_derivative_grey, "must be 1 to 63");
  check.NotNegative("min_texture", min_texture);
  check.Require(uniqueness_percent >= 0 && uniqueness_percent < 100, "uniqueness_percent",
                uniqueness_percent, "must be 0 to 99");
  check.NotNegative("left_right_px", left_right_px);
  check.NotNegative("min_segment_px", min_segment_px);
  check.NotNegative("segment_step_px", segment_step_px);
  check.Part(texture.Validate());
  return check.Take();
}

BmConfig BmConfig::Preset(std::string_view name) {
  BmConfig config;
  if (name == "block_15") {
    config.block_px = 15;
  } else if (name == "block_9") {
    config.block_px = 9;
  } else if (name == "block_21") {
    config.block_px = 21;
  } else {
    throw std::invalid_argument("unknown bm preset \"" + std::string(name) +
                                "\": known are block_15, block_9, block_21");
  }
  return config;
}

BmEstimator::BmEstimator(const BmConfig& config) : config_(config) {
  hardware::ThrowIfAny(config.Validate());
}

DisparityField BmEstimator::Estimate(const cv::Mat& left, const cv::Mat& right,
                                     hardware::StageTimes* times) {
  CheckPair(left, right);
  const BmConfig& c = config_;
  cv::Mat1s disparity_16(left.size(), static_cast<short>(16 * (c.range.min_px - 1)));
  const cv::Mat1b left_grey = ToGrey(left);
  const bool matchable =
      left.cols > c.range.UnmatchedColumns() + c.block_px && left.rows > c.block_px;
  if (matchable) {
    const auto matcher = cv::StereoBM::create(c.range.count_px, c.block_px);
    matcher->setMinDisparity(c.range.min_px);
    matcher->setPreFilterCap(c.max_derivative_grey);
    matcher->setTextureThreshold(c.min_texture);
    matcher->setUniquenessRatio(c.uniqueness_percent);
    matcher->setDisp12MaxDiff(c.left_right_px);
    matcher->setSpeckleWindowSize(c.min_segment_px);
    matcher->setSpeckleRange(c.segment_step_px);
    hardware::MeasureIf(times, "matching",
                        [&] { matcher->compute(left_grey, ToGrey(right), disparity_16); });
  }
  return hardware::MeasureIf(times, "checks", [&] {
    return FieldOfDisparity(disparity_16, c.range, c.texture.Apply(left_grey));
  });
}

}  // namespace horopter::vision
