// SPDX-License-Identifier: Apache-2.0
#include "sim/render/read_back.h"

#include <cstddef>
#include <limits>
#include <opencv2/imgproc.hpp>

namespace horopter::sim {
namespace {

/// Row y of an image, counted from its top, in pixels that start at the bottom.
const std::uint32_t* RowOf(const std::vector<std::uint32_t>& pixels, cv::Size size, int y) {
  return pixels.data() + static_cast<std::size_t>(size.height - 1 - y) * size.width;
}

}  // namespace

void ReadBack::Fetch(cv::Size size, GLenum format, GLenum type,
                     std::vector<std::uint32_t>& pixels) const {
  pixels.resize(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
  gl_.ReadPixels(0, 0, size.width, size.height, format, type, pixels.data());
}

void ReadBack::FetchColours(cv::Size size) {
  Fetch(size, GL_RGBA, GL_UNSIGNED_BYTE, colours_);
  colours_size_ = size;
}

void ReadBack::FetchDepth(cv::Size size) {
  Fetch(size, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, depth_);
  depth_size_ = size;
}

cv::Mat3b ReadBack::Bgr() const {
  cv::Mat3b bgr(colours_size_);
  for (int y = 0; y < bgr.rows; ++y) {
    const std::uint32_t* row = RowOf(colours_, colours_size_, y);
    std::uint8_t* out = bgr.ptr<std::uint8_t>(y);
    for (int x = 0; x < bgr.cols; ++x, out += 3) {
      const std::uint32_t rgba = row[x];  // red lowest
      out[0] = static_cast<std::uint8_t>(rgba >> 16);
      out[1] = static_cast<std::uint8_t>(rgba >> 8);
      out[2] = static_cast<std::uint8_t>(rgba);
    }
  }
  return bgr;
}

cv::Mat1f ReadBack::Depth(double near_m, double far_m) const {
  // Window depth d of a perspective frustum is linear in 1/z: 1/z = 1/near + d (1/far - 1/near).
  // The planes are those OpenGL got, as floats.
  constexpr std::uint32_t kFarthest = (1u << 24) - 1;
  const double nearest = 1.0 / static_cast<float>(near_m);
  const double slope = (1.0 / static_cast<float>(far_m) - nearest) / kFarthest;
  cv::Mat1f depth(depth_size_);
  for (int y = 0; y < depth.rows; ++y) {
    const std::uint32_t* row = RowOf(depth_, depth_size_, y);
    float* out = depth[y];
    for (int x = 0; x < depth.cols; ++x) {
      const auto d = static_cast<std::int32_t>(row[x] >> 8);
      const auto z = static_cast<float>(1.0 / (nearest + slope * d));
      out[x] =
          d == static_cast<std::int32_t>(kFarthest) ? std::numeric_limits<float>::infinity() : z;
    }
  }
  return depth;
}

cv::Mat1i ReadBack::Lookup(const std::vector<int>& meaning) const {
  const bool many = UsesHighByte(meaning);
  cv::Mat1i found(colours_size_);
  for (int y = 0; y < found.rows; ++y) {
    const std::uint32_t* low = RowOf(colours_, colours_size_, y);
    const std::uint32_t* high = many ? RowOf(depth_, depth_size_, y) : nullptr;
    int* out = found[y];
    for (int x = 0; x < found.cols; ++x) {
      const std::uint32_t number = (low[x] >> 24) | (many ? (high[x] & 0xFFu) << 8 : 0u);
      out[x] = meaning[number];
    }
  }
  return found;
}

cv::Mat3b Halved(const cv::Mat3b& bgr) {
  cv::Mat3b half;
  cv::resize(bgr, half, bgr.size() / 2, 0, 0, cv::INTER_AREA);
  return half;
}

}  // namespace horopter::sim
