// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "sim/camera/row_kernels.h"

namespace horopter::sim {

/// Sums bilinear samples of an image for one row of another.
///
/// Positions are rounded to 1/128 pixel, a largest error of 0.004 px (cv::remap: 1/32 and 0.016).
/// From there on integer arithmetic: the same bits on every processor.
class BilinearRow {
 public:
  /// Where the samples of a row lie: at H (x_i, y_i, 1) + w_i e, seen from another place at inverse
  /// depths w; positions outside are moved to the border.
  struct Places {
    Eigen::Matrix3f H;  ///< homography from (x, y, 1) to pixels of the image
    const float* x;     ///< RoundedUp(width) readable values each
    const float* y;
    Eigen::Vector3f e = Eigen::Vector3f::Zero();
    const float* w = nullptr;  ///< likewise; null: all zero
  };

  /// The largest image to take samples from, in both directions [px].
  static constexpr int kLargestSide = 10922;
  /// Values are taken several at a time: how many `width` values must be readable.
  static constexpr std::size_t RoundedUp(int width) {
    return (static_cast<std::size_t>(width) + kRowWidthStep - 1) / kRowWidthStep * kRowWidthStep;
  }

  explicit BilinearRow(const RowKernels& kernels = FastestRowKernels()) : kernels_(&kernels) {}

  /// Forgets all samples. Keeps its memory.
  void Start(int width);

  /// Adds a sample to every pixel. @param image from 4 x 2 pixels up to kLargestSide
  void Add(const cv::Mat3b& image, const Places& places);

  /// Means of what was added, rounded, three values per pixel. @pre at least one Add()
  void Store(std::uint8_t* row) const;

  /// What Start(), one Add() and Store() give, in one go.
  void Sample(const cv::Mat3b& image, const Places& places, int width, std::uint8_t* row) const;

 private:
  const RowKernels* kernels_;
  int width_ = 0;
  int count_ = 0;
  std::vector<std::int32_t> sum_;  ///< four per pixel, the last unused; sums of 2^14 x grey level
};

}  // namespace horopter::sim
