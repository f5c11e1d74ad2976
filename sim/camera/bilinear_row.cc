// SPDX-License-Identifier: Apache-2.0
#include "sim/camera/bilinear_row.h"

#include <algorithm>
#include <opencv2/core.hpp>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

#if defined(__x86_64__) && defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define HOROPTER_WIDEST __attribute__((target_clones("avx2", "default")))
#else
#define HOROPTER_WIDEST
#endif

namespace horopter::sim {
namespace {

constexpr int kFractionBits = 7;
constexpr int kOne = 1 << kFractionBits;

/// Where samples lie: a byte offset into the image, and the weights of the four pixels there.
struct Places {
  std::int32_t* offset;
  std::int32_t* upper;
  std::int32_t* lower;
};

/// The compiler turns this loop into vectors of whatever width the processor has.
HOROPTER_WIDEST
void FindPlaces(const float* h, const float* x, const float* y, int count, float last_x,
                float last_y, int stride, Places to) {
  for (int i = 0; i < count; ++i) {
    const float scale = 1.0F / (h[2] * x[i] + h[5] * y[i] + h[8]);
    const float u = (h[0] * x[i] + h[3] * y[i] + h[6]) * scale;
    const float v = (h[1] * x[i] + h[4] * y[i] + h[7]) * scale;
    const float u_in = u < 0 ? 0 : (u > last_x ? last_x : u);
    const float v_in = v < 0 ? 0 : (v > last_y ? last_y : v);
    const int u_fixed = static_cast<int>(u_in * kOne + 0.5F);
    const int v_fixed = static_cast<int>(v_in * kOne + 0.5F);
    const int right = u_fixed & (kOne - 1), left = kOne - right;
    const int below = v_fixed & (kOne - 1), above = kOne - below;
    to.offset[i] = (v_fixed >> kFractionBits) * stride + (u_fixed >> kFractionBits) * 3;
    to.upper[i] = (above * left) | (above * right) << 16;
    to.lower[i] = (below * left) | (below * right) << 16;
  }
}

#ifdef __SSE2__

/// Two neighbouring pixels, interleaved: b b' g g' r r' as 16 bits each.
inline __m128i Neighbours(const std::uint8_t* pixel) {
  const __m128i bytes = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(pixel));
  const __m128i pairs = _mm_unpacklo_epi8(bytes, _mm_srli_epi64(bytes, 24));
  return _mm_unpacklo_epi8(pairs, _mm_setzero_si128());
}

void Gather(const std::uint8_t* image, int stride, const Places& from, int count,
            std::int32_t* sum) {
  for (int i = 0; i < count; ++i) {
    const std::uint8_t* pixel = image + from.offset[i];
    const __m128i above = _mm_madd_epi16(Neighbours(pixel), _mm_set1_epi32(from.upper[i]));
    const __m128i below = _mm_madd_epi16(Neighbours(pixel + stride), _mm_set1_epi32(from.lower[i]));
    __m128i* to = reinterpret_cast<__m128i*>(sum + 4 * i);
    _mm_storeu_si128(to, _mm_add_epi32(_mm_loadu_si128(to), _mm_add_epi32(above, below)));
  }
}

#else

void Gather(const std::uint8_t* image, int stride, const Places& from, int count,
            std::int32_t* sum) {
  for (int i = 0; i < count; ++i) {
    const std::uint8_t* upper = image + from.offset[i];
    const std::uint8_t* lower = upper + stride;
    const std::int32_t a = from.upper[i] & 0xffff, b = from.upper[i] >> 16;
    const std::int32_t c = from.lower[i] & 0xffff, d = from.lower[i] >> 16;
    for (int k = 0; k < 3; ++k) {
      sum[4 * i + k] += a * upper[k] + b * upper[k + 3] + c * lower[k] + d * lower[k + 3];
    }
  }
}

#endif

}  // namespace

void BilinearRow::Start(int width) {
  width_ = width;
  count_ = 0;
  const auto size = static_cast<std::size_t>(width);
  sum_.assign(4 * size, 0);
  offset_.resize(size);
  upper_weights_.resize(size);
  lower_weights_.resize(size);
}

void BilinearRow::Add(const cv::Mat3b& image, const Eigen::Matrix3f& H, const float* x,
                      const float* y) {
  CV_Assert(image.cols >= 4 && image.rows >= 2);
  // Eight bytes are read where six are meant: no pixel beyond the third-last begins a pair.
  constexpr float kAlmostOne = (kOne - 1.0F) / kOne;
  const Places places{offset_.data(), upper_weights_.data(), lower_weights_.data()};
  const int stride = static_cast<int>(image.step);
  FindPlaces(H.data(), x, y, width_, image.cols - 3 + kAlmostOne, image.rows - 2 + kAlmostOne,
             stride, places);
  Gather(image.ptr(), stride, places, width_, sum_.data());
  ++count_;
}

void BilinearRow::Store(std::uint8_t* row) const {
  const float scale = 1.0F / (static_cast<float>(kOne * kOne) * static_cast<float>(count_));
  for (int i = 0; i < width_; ++i) {
    for (int k = 0; k < 3; ++k) {
      row[3 * i + k] =
          static_cast<std::uint8_t>(static_cast<float>(sum_[4 * i + k]) * scale + 0.5F);
    }
  }
}

}  // namespace horopter::sim
