// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include "hardware/types/config_error.h"
#include "vision/disparity/disparity_estimator.h"
#include "vision/disparity/search_range.h"
#include "vision/disparity/texture_check.h"

namespace horopter::vision {

/// Parameters of cv::StereoBM, with its x-Sobel pre-filter.
struct BmConfig {
  SearchRange range;
  /// Width of the matched blocks.
  int block_px = 15;
  /// The pre-filter's x-derivatives are cut off here [grey levels]. OpenCV's default.
  int max_derivative_grey = 31;
  /// Sum of a block's absolute derivatives below which it is not matched. OpenCV's default.
  int min_texture = 10;
  /// By how much the best cost must be below any other's. OpenCV's sample: 15.
  int uniqueness_percent = 15;
  /// Largest distance between a pixel and where its match points back to [px].
  int left_right_px = 1;
  /// Smallest segment of smooth disparity that is kept [px], and the largest step inside one [px].
  int min_segment_px = 100;
  int segment_step_px = 2;
  TextureCheck texture;

  /// Every field that does not hold.
  std::vector<hardware::FieldError> Validate() const;

  /// By the width of the blocks: "block_15", "block_9", "block_21".
  /// @throws std::invalid_argument that lists the known names.
  static BmConfig Preset(std::string_view name);
};

/// A peer for rectified pairs: OpenCV's block matching by sums of absolute differences (Konolige).
/// dy is 0 and dx = -(x_left - x_right).
///
/// Invalid is what OpenCV gives up, what has no texture, and the columns for which the range leads
/// beyond the right image: images no wider than that have no valid pixel. Confidence is 1 where
/// valid.
class BmEstimator final : public DisparityEstimator {
 public:
  /// @throws ConfigError naming every bad field.
  explicit BmEstimator(const BmConfig& config);

  using DisparityEstimator::Estimate;
  DisparityField Estimate(const cv::Mat& left, const cv::Mat& right,
                          hardware::StageTimes* times) override;
  std::string_view name() const override { return "bm"; }

 private:
  BmConfig config_;
};

}  // namespace horopter::vision
