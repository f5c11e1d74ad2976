// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <vector>

namespace horopter::sim {

/// Sums bilinear samples of an image for one row of another.
///
/// Positions are rounded to 1/128 pixel, a largest error of 0.004 px (cv::remap: 1/32 and 0.016).
/// From there on integer arithmetic: the same bits on every processor.
class BilinearRow {
 public:
  /// The largest image to take samples from, in both directions [px].
  static constexpr int kLargestSide = 10922;
  /// Values are taken four at a time: how many `width` values must be readable.
  static constexpr std::size_t RoundedUp(int width) {
    return (static_cast<std::size_t>(width) + 3) / 4 * 4;
  }

  /// Forgets all samples. Keeps its memory.
  void Start(int width);

  /// Adds image(H (x_i, y_i, 1)) for each i; positions outside are moved to the border.
  /// @param image from 4 x 2 pixels up to kLargestSide
  /// @param H homography from (x, y, 1) to pixels of `image`
  /// @param x, y RoundedUp(width) readable values each
  void Add(const cv::Mat3b& image, const Eigen::Matrix3f& H, const float* x, const float* y) {
    Add(image, H, Eigen::Vector3f::Zero(), x, y, nullptr);
  }

  /// Adds image(H (x_i, y_i, 1) + w_i e): seen from another place, at inverse depths w.
  /// @param w RoundedUp(width) readable values, or null where they are all zero
  void Add(const cv::Mat3b& image, const Eigen::Matrix3f& H, const Eigen::Vector3f& e,
           const float* x, const float* y, const float* w);

  /// Means of what was added, rounded, three values per pixel. @pre at least one Add()
  void Store(std::uint8_t* row) const;

 private:
  int width_ = 0;
  int count_ = 0;
  std::vector<std::int32_t> sum_;  ///< four per pixel, the last unused; sums of 2^14 x grey level
};

}  // namespace horopter::sim
