// SPDX-License-Identifier: Apache-2.0
#include "sim/camera/motion_comb.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/core.hpp>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace horopter::sim {
namespace {

/// target = (a + b) / 2, halves rounded up or down.
void Mean(const std::uint8_t* a, const std::uint8_t* b, int count, bool up, std::uint8_t* target) {
  int i = 0;
#ifdef __SSE2__
  const __m128i one = up ? _mm_setzero_si128() : _mm_set1_epi8(1);
  for (; i + 16 <= count; i += 16) {
    const __m128i x = _mm_loadu_si128(reinterpret_cast<const __m128i*>(a + i));
    const __m128i y = _mm_loadu_si128(reinterpret_cast<const __m128i*>(b + i));
    const __m128i odd = _mm_and_si128(_mm_xor_si128(x, y), one);
    _mm_storeu_si128(reinterpret_cast<__m128i*>(target + i), _mm_sub_epi8(_mm_avg_epu8(x, y), odd));
  }
#endif
  for (; i < count; ++i) target[i] = static_cast<std::uint8_t>((a[i] + b[i] + (up ? 1 : 0)) >> 1);
}

/// target(p) = (source(p) + source(p + shift)) / 2; where that lies outside, source(p).
void MeanWithShifted(const cv::Mat3b& source, const Eigen::Vector2i& shift, bool up,
                     cv::Mat3b& target) {
  target.create(source.size());
  const int first = std::clamp(-shift.x(), 0, source.cols);
  const int last = std::clamp(source.cols - shift.x(), first, source.cols);
  cv::parallel_for_(cv::Range(0, source.rows), [&](const cv::Range& rows) {
    for (int y = rows.start; y < rows.end; ++y) {
      const int other_row = y + shift.y();
      const bool inside = other_row >= 0 && other_row < source.rows;
      const int begin = inside ? 3 * first : 0, end = inside ? 3 * last : 0;
      const std::uint8_t* here = source.ptr<std::uint8_t>(y);
      std::uint8_t* to = target.ptr<std::uint8_t>(y);
      std::copy(here, here + begin, to);
      std::copy(here + end, here + 3 * source.cols, to + end);
      if (!inside) continue;
      const std::uint8_t* there = source.ptr<std::uint8_t>(other_row) + 3 * (first + shift.x());
      Mean(here + begin, there, end - begin, up, to + begin);
    }
  });
}

}  // namespace

void MotionComb::Make(const cv::Mat3b& view, const Eigen::Vector2d& step_px, int levels) {
  levels_ = std::clamp(levels, 1, kLevels);
  images_[0] = view;
  for (int level = 1; level < levels_; ++level) {
    const Eigen::Vector2d way = step_px * Taps(level - 1);
    // One level rounds up and the next down, so that together they are no brighter.
    shifts_[level] = way.array().round().cast<int>();
    MeanWithShifted(images_[level - 1], shifts_[level], level % 2 == 1, images_[level]);
  }
}

Eigen::Vector2d MotionComb::Extent(int level) const {
  Eigen::Vector2d extent = Eigen::Vector2d::Zero();
  for (int i = 1; i <= level; ++i) extent += shifts_[i].cast<double>();
  return extent;
}

double MotionComb::Variance(int level) const {
  double variance = 0;
  for (int i = 1; i <= level; ++i) variance += shifts_[i].squaredNorm() / 4.0;
  return variance;
}

}  // namespace horopter::sim
