// SPDX-License-Identifier: Apache-2.0
#include "vision/segmentation/colour_edges.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <string>

#include "hardware/types/field_checker.h"

namespace horopter::vision {
namespace {

/// Three rows of interleaved BGR, the middle one being the pixel's.
struct Rows {
  const std::uint8_t* above;
  const std::uint8_t* here;
  const std::uint8_t* below;
};

/// |d/dx| + |d/dy| of one channel; l, c, r are byte offsets of the columns left of, at and right of
/// the pixel.
int CentralNorm(const Rows& rows, int l, int c, int r) {
  return std::abs(rows.here[r] - rows.here[l]) + std::abs(rows.below[c] - rows.above[c]);
}

int SobelNorm4(const Rows& rows, int l, int c, int r) {
  const int dx = rows.above[r] - rows.above[l] + 2 * (rows.here[r] - rows.here[l]) + rows.below[r] -
                 rows.below[l];
  const int dy = rows.below[l] - rows.above[l] + 2 * (rows.below[c] - rows.above[c]) +
                 rows.below[r] - rows.above[r];
  return std::abs(dx) + std::abs(dy);
}

template <typename Norm>
cv::Mat1b Threshold(const cv::Mat& bgr, int threshold, const Norm& norm) {
  cv::Mat1b interior(bgr.size());
  cv::parallel_for_(cv::Range(0, bgr.rows), [&](const cv::Range& range) {
    for (int v = range.start; v < range.end; ++v) {
      const Rows rows{bgr.ptr(std::max(v - 1, 0)), bgr.ptr(v),
                      bgr.ptr(std::min(v + 1, bgr.rows - 1))};
      for (int u = 0; u < bgr.cols; ++u) {
        const int l = 3 * std::max(u - 1, 0), c = 3 * u, r = 3 * std::min(u + 1, bgr.cols - 1);
        int sum = 0;
        for (int channel = 0; channel < 3; ++channel) {
          sum += norm(rows, l + channel, c + channel, r + channel);
        }
        interior(v, u) = sum > threshold ? 0 : 255;
      }
    }
  });
  return interior;
}

}  // namespace

std::vector<hardware::FieldError> ColourEdgesConfig::Validate() const {
  hardware::FieldChecker check("colour_edges.");
  check.Require(median_px >= 1 && median_px % 2 == 1 && median_px <= 255, "median_px", median_px,
                "must be odd and between 1 and 255");
  check.Require(threshold >= 0, "threshold", threshold, "must not be negative");
  return check.Take();
}

cv::Mat1b FindColourEdges(const cv::Mat& bgr, const ColourEdgesConfig& config) {
  hardware::ThrowIfAny(config.Validate());
  if (bgr.empty() || bgr.type() != CV_8UC3) {
    throw std::invalid_argument("colour edges need a non-empty 8-bit BGR image, got " +
                                cv::typeToString(bgr.type()) + " of " + std::to_string(bgr.cols) +
                                "x" + std::to_string(bgr.rows));
  }
  cv::Mat smooth;
  if (config.median_px > 1) {
    cv::medianBlur(bgr, smooth, config.median_px);
  } else {
    smooth = bgr;
  }
  if (config.kernel == GradientKernel::kCentral) {
    return Threshold(smooth, config.threshold, CentralNorm);
  }
  return Threshold(smooth, 4 * config.threshold, SobelNorm4);
}

}  // namespace horopter::vision
