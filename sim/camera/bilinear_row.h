// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "sim/camera/row_kernels.h"

namespace horopter::sim {

/// One row of an image whose pixels are means of bilinear samples of others.
///
/// Positions are rounded to 1/128 pixel, a largest error of 0.004 px (cv::remap: 1/32 and 0.016).
/// From there on integer arithmetic: the same bits on every processor.
class BilinearRow {
 public:
  /// The largest image to take samples from, in both directions [px].
  static constexpr int kLargestSide = 10922;
  /// Values are taken several at a time: how many `width` values must be readable.
  static constexpr std::size_t RoundedUp(int width) {
    return (static_cast<std::size_t>(width) + kRowWidthStep - 1) / kRowWidthStep * kRowWidthStep;
  }

  explicit BilinearRow(const RowKernels& kernels = FastestRowKernels()) : kernels_(&kernels) {}

  /// Forgets all samples. Keeps its memory.
  void Start() { from_.clear(); }

  /// Adds image(H (x_i, y_i, 1) + w_i e) to each pixel i: seen from another place, at inverse
  /// depths w; positions outside are moved to the border.
  /// @param image from 4 x 2 pixels up to kLargestSide; must outlive Store()
  /// @param H homography from (x, y, 1) to pixels of `image`
  void Add(const cv::Mat3b& image, const Eigen::Matrix3f& H,
           const Eigen::Vector3f& e = Eigen::Vector3f::Zero());

  /// Means of what was added, rounded, three values per pixel. @pre at least one Add()
  /// @param places x, y and w, RoundedUp(width) readable values each
  void Store(const SampleRow& places, std::uint8_t* row) const {
    kernels_->sample(from_.data(), static_cast<int>(from_.size()), places, row);
  }

 private:
  const RowKernels* kernels_;
  std::vector<SampleSource> from_;
};

}  // namespace horopter::sim
