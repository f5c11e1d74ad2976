// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "sim/render/gl_functions.h"

namespace horopter::sim {

/// Pixels of the current frame buffer as OpenGL packs them, four bytes each, and the images made of
/// them. OpenGL's first row is the lowest; the images' is the top.
class ReadBack {
 public:
  explicit ReadBack(const GlFunctions& gl) : gl_(gl) {}

  /// Colours and, in alpha, the low byte of the numbers.
  void FetchColours(cv::Size size);
  /// Depth in 24 bits and, in the stencil, the high byte of the numbers.
  void FetchDepth(cv::Size size);

  /// Of the colours fetched last.
  cv::Mat3b Bgr() const;
  /// Of the depth fetched last: along the optical axis [m], +inf where nothing was drawn.
  /// @param near_m,far_m clip planes of the perspective it was drawn with
  cv::Mat1f Depth(double near_m, double far_m) const;
  /// Of the colours fetched last and, when UsesHighByte(), the depth: what each pixel's number
  /// stands for.
  /// @param meaning of 256 numbers, or of 65536
  static bool UsesHighByte(const std::vector<int>& meaning) { return meaning.size() > 256; }
  cv::Mat1i Lookup(const std::vector<int>& meaning) const;

 private:
  void Fetch(cv::Size size, GLenum format, GLenum type, std::vector<std::uint32_t>& pixels) const;

  const GlFunctions& gl_;
  cv::Size colours_size_;
  cv::Size depth_size_;
  std::vector<std::uint32_t> colours_;
  std::vector<std::uint32_t> depth_;
};

/// Each pixel the mean of 2 x 2, rounded.
cv::Mat3b Halved(const cv::Mat3b& bgr);

}  // namespace horopter::sim
