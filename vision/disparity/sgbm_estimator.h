// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/calib3d.hpp>
#include <string_view>
#include <vector>

#include "hardware/types/config_error.h"
#include "vision/disparity/disparity_estimator.h"
#include "vision/disparity/search_range.h"
#include "vision/disparity/texture_check.h"

namespace horopter::vision {

/// Parameters of cv::StereoSGBM.
struct SgbmConfig {
  SearchRange range;
  /// How many directions the costs are added along, and from where.
  int mode = cv::StereoSGBM::MODE_SGBM_3WAY;
  /// Match colours where the images have any; else grey levels.
  bool colour = false;
  /// Width of the matched blocks. OpenCV's sample: 3.
  int block_px = 3;
  /// Penalties of a step of 1 px and of any larger one, per channel and pixel of the block.
  /// OpenCV's sample.
  int small_step_penalty = 8;
  int large_step_penalty = 32;
  /// The pre-filter's x-derivatives are cut off here [grey levels]. OpenCV's sample.
  int max_derivative_grey = 63;
  /// By how much the best cost must be below any other's. OpenCV's manual: 5 to 15.
  int uniqueness_percent = 10;
  /// Largest distance between a pixel and where its match points back to [px].
  int left_right_px = 1;
  /// Smallest segment of smooth disparity that is kept [px], and the largest step inside one [px].
  int min_segment_px = 100;
  int segment_step_px = 2;
  TextureCheck texture;

  /// Every field that does not hold.
  std::vector<hardware::FieldError> Validate() const;

  /// The modes of OpenCV: "3way" (three directions; the fastest), "sgbm" (five), "hh" (eight, whole
  /// image in memory), "hh4" (four, both ways); and "3way_colour".
  /// @throws std::invalid_argument that lists the known names.
  static SgbmConfig Preset(std::string_view name);
};

/// A peer for rectified pairs: OpenCV's semi-global matching (Hirschmueller, PAMI 2008, with the
/// costs of Birchfield & Tomasi). dy is 0 and dx = -(x_left - x_right).
///
/// Invalid is what OpenCV gives up, what has no texture, and the columns for which the range leads
/// beyond the right image: images no wider than that have no valid pixel. Confidence is 1 where
/// valid. Pairs for which a mode that holds the whole image would take over 4 GB throw
/// std::invalid_argument besides.
class SgbmEstimator final : public DisparityEstimator {
 public:
  /// @throws ConfigError naming every bad field.
  explicit SgbmEstimator(const SgbmConfig& config);

  using DisparityEstimator::Estimate;
  DisparityField Estimate(const cv::Mat& left, const cv::Mat& right,
                          hardware::StageTimes* times) override;
  std::string_view name() const override { return "sgbm"; }

 private:
  SgbmConfig config_;
};

}  // namespace horopter::vision
