// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/edge_map.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace horopter::vision {
namespace {

/// Sum over channels of |a - b|, less `ignored`, for a row of pixels.
void Differences(const std::uint8_t* a, const std::uint8_t* b, int count, int channels, int ignored,
                 std::uint8_t* out) {
  for (int x = 0; x < count; ++x) {
    const int i = x * channels;
    const int sum = channels == 1 ? 3 * std::abs(a[i] - b[i])
                                  : std::abs(a[i] - b[i]) + std::abs(a[i + 1] - b[i + 1]) +
                                        std::abs(a[i + 2] - b[i + 2]);
    out[x] = static_cast<std::uint8_t>(std::clamp(sum - ignored, 0, 255));
  }
}

}  // namespace

void FindEdges(const cv::Mat& image, int ignored, EdgeMap& edges) {
  const int width = image.cols, channels = image.channels();
  edges.x.Resize(width, image.rows);
  edges.y.Resize(width, image.rows);
  for (int y = 0; y < image.rows; ++y) {
    const std::uint8_t* row = image.ptr(y);
    std::uint8_t* to_left = edges.x.data() + static_cast<std::ptrdiff_t>(y) * width;
    to_left[0] = 0;
    Differences(row + channels, row, width - 1, channels, ignored, to_left + 1);
    Differences(row, image.ptr(std::max(0, y - 1)), width, channels, ignored,
                edges.y.data() + static_cast<std::ptrdiff_t>(y) * width);
  }
}

PoolingWeights MakePoolingWeights(double deviation_px, double colour_grey) {
  PoolingWeights weights;
  for (std::size_t difference = 0; difference < weights.size(); ++difference) {
    const double distance = 1 + deviation_px / colour_grey * static_cast<double>(difference);
    const double weight = std::exp(-std::numbers::sqrt2 / deviation_px * distance);
    weights[difference] = static_cast<std::int16_t>(std::lround(32767 * weight));
  }
  return weights;
}

}  // namespace horopter::vision
