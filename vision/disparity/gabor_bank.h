// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <opencv2/core/mat.hpp>

#include "vision/disparity/v1_config.h"

namespace horopter::vision {

/// Orientation i of the bank: the direction in the image (x right, y down) along which the filter
/// oscillates, and along which it therefore measures disparity.
inline constexpr double OrientationRad(int i) { return i * 3.14159265358979323846 / kOrientations; }

/// Responses at one pixel of the quadrature pair of simple cells of every orientation, in grey
/// levels: a sinusoid of amplitude A at the peak frequency gives a magnitude of A / 2.
struct SimpleCells {
  std::array<float, kOrientations> even;  ///< real part (C)
  std::array<float, kOrientations> odd;   ///< imaginary part (S)
};

/// SimpleCells of every pixel of an image.
class SimpleCellMap {
 public:
  explicit SimpleCellMap(cv::Size size)
      : data_(size.height, size.width * kFloats, CV_32F), size_(size) {}

  cv::Size size() const { return size_; }
  SimpleCells* row(int y) { return reinterpret_cast<SimpleCells*>(data_.ptr<float>(y)); }
  const SimpleCells* row(int y) const {
    return reinterpret_cast<const SimpleCells*>(data_.ptr<float>(y));
  }

  /// Responses at a position between pixels, bilinear. @pre 0 <= x <= width - 1, likewise y.
  SimpleCells At(float x, float y) const;

 private:
  static constexpr int kFloats = sizeof(SimpleCells) / sizeof(float);

  cv::Mat data_;
  cv::Size size_;
};

/// The linear stage of V1: complex Gabor filters of kOrientations orientations,
///   g(x) = exp(-|x|^2 / (2 sigma^2)) (exp(2 pi i f0 n.x) - dc) / sum of the Gaussian,
/// with n the orientation's direction, and dc real such that a constant image gives nothing.
/// Separable: cos(a + b) and sin(a + b) are sums of products of 1-D kernels, and orientations that
/// mirror each other (theta and pi - theta) share them. Borders are replicated.
class GaborBank {
 public:
  /// @pre config.Validate() is empty
  explicit GaborBank(const V1Config& config);

  /// @param grey 0 to 255, any size from 1x1
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
  std::array<Kernel1D, kOrientations / 2 + 1> along_x_;  ///< for theta up to pi / 2
  std::array<Kernel1D, kOrientations / 2 + 1> along_y_;
};

}  // namespace horopter::vision
