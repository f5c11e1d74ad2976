// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <optional>

namespace horopter::vision {

/// Errors beyond these count as bad [px], as the Middlebury benchmark has them.
inline constexpr std::array<double, 4> kBadLimitsPx = {0.5, 1, 2, 4};

/// How far an estimate is from the truth, over the pixels whose truth is known. Statistics of
/// nothing are NaN.
struct ErrorScore {
  std::int64_t known = 0;      ///< pixels whose truth is known
  std::int64_t estimated = 0;  ///< of these, the ones that have an estimate
  double density = 0;          ///< estimated / known
  double mean_px = 0;          ///< of the absolute error (of a vector: its length), like the rest
  double median_px = 0;
  double rms_px = 0;
  double max_px = 0;
  cv::Point max_at;  ///< where the largest error is; the first of equals
  /// Share beyond each of kBadLimitsPx: of the estimated, and of the known with those that have no
  /// estimate counted as bad.
  std::array<double, 4> bad_estimated{};
  std::array<double, 4> bad_known{};
};

/// A disparity map or vector field: NaN or infinite = unknown. All maps have one size.
struct DisparityMaps {
  cv::Mat1f dx;  ///< x_right - x_left [px]
  cv::Mat1f dy;  ///< y_right - y_left [px]; empty where nobody says: a map of horizontal disparity
};

/// Components apart; the vertical one, and the vector, where both sides have it.
struct FieldScores {
  ErrorScore dx;
  std::optional<ErrorScore> dy;
  std::optional<ErrorScore> vector;
};

/// @param mask CV_8UC1, other than 0 = counts; empty = everything counts
/// @throws std::invalid_argument stating both sizes when they differ, and when no pixel's truth is
///         known
FieldScores ScoreDisparity(const DisparityMaps& estimate, const DisparityMaps& truth,
                           const cv::Mat1b& mask = {});

}  // namespace horopter::vision
