// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "vision/disparity/v1_config.h"

namespace horopter::vision {

/// Most orientations that a bank may have.
inline constexpr int kMaxOrientations = 16;

/// Orientation i of a bank: the direction in the image (x right, y down) along which the filter
/// oscillates, and along which it therefore measures disparity.
inline constexpr double OrientationRad(int i, int orientations = kOrientations) {
  return i * 3.14159265358979323846 / orientations;
}

/// Responses at one pixel of the quadrature pair of simple cells of every orientation, in grey
/// levels: a sinusoid of amplitude A at the peak frequency gives a magnitude of A / 2. A view.
struct SimpleCells {
  const float* even;  ///< real part (C) of each orientation
  const float* odd;   ///< imaginary part (S)
};

/// SimpleCells of every pixel of an image.
class SimpleCellMap {
 public:
  /// SimpleCells of the pixels of one row.
  class Row {
   public:
    Row(const float* cells, int orientations) : cells_(cells), orientations_(orientations) {}
    SimpleCells operator[](int x) const {
      const float* even = cells_ + static_cast<std::ptrdiff_t>(x) * 2 * orientations_;
      return {even, even + orientations_};
    }

   private:
    const float* cells_;
    int orientations_;
  };

  /// @pre 2 <= orientations <= kMaxOrientations
  explicit SimpleCellMap(cv::Size size, int orientations = kOrientations)
      : data_(size.height, size.width * 2 * orientations, CV_32F),
        size_(size),
        orientations_(orientations) {}

  cv::Size size() const { return size_; }
  int orientations() const { return orientations_; }
  Row row(int y) const { return {data_.ptr<float>(y), orientations_}; }
  /// Pixel after pixel of a row: its even responses, then its odd ones.
  float* data(int y) { return data_.ptr<float>(y); }

  /// Responses at a position between pixels, bilinear, as a pixel of data() has them.
  /// @param cells room for 2 * orientations()
  /// @pre 0 <= x <= width - 1, likewise y.
  void At(float x, float y, float* cells) const;

 private:
  cv::Mat data_;
  cv::Size size_;
  int orientations_;
};

/// The linear stage of V1: complex Gabor filters of some orientations,
///   g(x) = exp(-|x|^2 / (2 sigma^2)) (exp(2 pi i f0 n.x) - dc) / sum of the Gaussian,
/// with n the orientation's direction, and dc real such that a constant image gives nothing.
/// Separable: cos(a + b) and sin(a + b) are sums of products of 1-D kernels, and orientations that
/// mirror each other (theta and pi - theta) share them. Borders are replicated.
class GaborBank {
 public:
  /// @pre config.Validate() is empty
  explicit GaborBank(const V1Config& config);

  /// @param grey 0 to 255, or normalised (NormaliseLocally); any size from 1x1
  SimpleCellMap Apply(const cv::Mat1f& grey) const;

 private:
  /// Gaussian times cosine and sine of one frequency.
  struct Kernel1D {
    cv::Mat1f even;
    cv::Mat1f odd;
    double even_sum = 0;
  };

  Kernel1D MakeKernel(const V1Config& config, double frequency) const;
  /// Fills orientation i and, where it has one, its mirror.
  void FilterOrientation(const cv::Mat1f& grey, const cv::Mat1f& blurred, int i,
                         SimpleCellMap& out) const;

  cv::Mat1f gaussian_;
  int orientations_;
  std::vector<Kernel1D> along_x_;  ///< for theta up to pi / 2
  std::vector<Kernel1D> along_y_;
};

}  // namespace horopter::vision
