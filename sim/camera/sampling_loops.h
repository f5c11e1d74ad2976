// SPDX-License-Identifier: Apache-2.0
#pragma once

// The sampling loops of RowKernels for any processor; where it has SSE2, four pixels at a time.

#include <cstdint>
#include <cstring>

#include "sim/camera/row_kernels.h"

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace horopter::sim::portable {

#ifdef __SSE2__

/// Two neighbouring pixels, interleaved: b b' g g' r r' as 16 bits each.
inline __m128i Neighbours(const std::uint8_t* pixel) {
  const __m128i bytes = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(pixel));
  const __m128i pairs = _mm_unpacklo_epi8(bytes, _mm_srli_epi64(bytes, 24));
  return _mm_unpacklo_epi8(pairs, _mm_setzero_si128());
}

/// Position on an axis, within the image, in steps of a place.
inline __m128i Fixed(__m128 position, float last) {
  const __m128 inside = _mm_min_ps(_mm_max_ps(position, _mm_setzero_ps()), _mm_set1_ps(last));
  return _mm_cvttps_epi32(
      _mm_add_ps(_mm_mul_ps(inside, _mm_set1_ps(kPlaceSteps)), _mm_set1_ps(0.5F)));
}

inline __m128 Affine(__m128 x, __m128 y, float a, float b, float c) {
  return _mm_add_ps(_mm_add_ps(_mm_mul_ps(_mm_set1_ps(a), x), _mm_mul_ps(_mm_set1_ps(b), y)),
                    _mm_set1_ps(c));
}

/// Where four samples lie: byte offsets, and the weights of two neighbours above and below, 16 bits
/// each.
struct FourPlaces {
  alignas(16) std::int32_t offset[4];
  alignas(16) std::int32_t above[4];
  alignas(16) std::int32_t below[4];
};

template <bool kParallax>
inline void FindFour(const SampleSource& from, const SampleRow& row, int i, FourPlaces& to) {
  const float* h = from.h;
  const __m128 x = _mm_loadu_ps(row.x + i), y = _mm_loadu_ps(row.y + i);
  __m128 p = Affine(x, y, h[0], h[3], h[6]), q = Affine(x, y, h[1], h[4], h[7]);
  __m128 r = Affine(x, y, h[2], h[5], h[8]);
  if constexpr (kParallax) {
    const __m128 w = _mm_loadu_ps(row.w + i);
    p = _mm_add_ps(p, _mm_mul_ps(w, _mm_set1_ps(from.e[0])));
    q = _mm_add_ps(q, _mm_mul_ps(w, _mm_set1_ps(from.e[1])));
    r = _mm_add_ps(r, _mm_mul_ps(w, _mm_set1_ps(from.e[2])));
  }
  const __m128 scale = _mm_div_ps(_mm_set1_ps(1), r);
  const __m128i u = Fixed(_mm_mul_ps(p, scale), from.last_x);
  const __m128i v = Fixed(_mm_mul_ps(q, scale), from.last_y);
  const __m128i one = _mm_set1_epi32(kPlaceSteps), fraction = _mm_set1_epi32(kPlaceSteps - 1);
  const __m128i right = _mm_and_si128(u, fraction), left = _mm_sub_epi32(one, right);
  const __m128i down = _mm_and_si128(v, fraction), up = _mm_sub_epi32(one, down);
  // Column and row as 16 bits of one word, times bytes per pixel and per row.
  const __m128i cell = _mm_or_si128(_mm_slli_epi32(_mm_srli_epi32(u, kPlaceBits), 16),
                                    _mm_srli_epi32(v, kPlaceBits));
  const __m128i bytes = _mm_set1_epi32((3 << 16) | from.stride);
  const auto store = [](std::int32_t* where, __m128i what) {
    _mm_store_si128(reinterpret_cast<__m128i*>(where), what);
  };
  const __m128i sides = _mm_or_si128(left, _mm_slli_epi32(right, 16));
  const auto twice = [](__m128i n) { return _mm_or_si128(n, _mm_slli_epi32(n, 16)); };
  store(to.offset, _mm_madd_epi16(cell, bytes));
  store(to.above, _mm_mullo_epi16(sides, twice(up)));
  store(to.below, _mm_mullo_epi16(sides, twice(down)));
}

inline void AddSample(const SampleSource& from, const FourPlaces& places, int k,
                      std::int32_t* sum) {
  const std::uint8_t* pixel = from.pixels + places.offset[k];
  const __m128i above = _mm_madd_epi16(Neighbours(pixel), _mm_set1_epi32(places.above[k]));
  const __m128i below =
      _mm_madd_epi16(Neighbours(pixel + from.stride), _mm_set1_epi32(places.below[k]));
  __m128i* to = reinterpret_cast<__m128i*>(sum);
  _mm_storeu_si128(to, _mm_add_epi32(_mm_loadu_si128(to), _mm_add_epi32(above, below)));
}

template <bool kParallax>
void AddSamplesWith(const SampleSource& from, const SampleRow& row, std::int32_t* sum) {
  FourPlaces places;
  for (int i = 0; i < row.width; i += 4) {
    FindFour<kParallax>(from, row, i, places);
    for (int k = 0; k < 4; ++k) AddSample(from, places, k, sum + 4 * (i + k));
  }
}

#else

inline int Fixed(float position, float last) {
  const float inside = position > 0 ? (position < last ? position : last) : 0;
  return static_cast<int>(inside * kPlaceSteps + 0.5F);
}

template <bool kParallax>
void AddSamplesWith(const SampleSource& from, const SampleRow& row, std::int32_t* sum) {
  const float *h = from.h, *e = from.e;
  for (int i = 0; i < row.width; ++i) {
    const float x = row.x[i], y = row.y[i], w = kParallax ? row.w[i] : 0;
    const float scale = 1.0F / (h[2] * x + h[5] * y + h[8] + w * e[2]);
    const int u = Fixed((h[0] * x + h[3] * y + h[6] + w * e[0]) * scale, from.last_x);
    const int v = Fixed((h[1] * x + h[4] * y + h[7] + w * e[1]) * scale, from.last_y);
    const int right = u & (kPlaceSteps - 1), left = kPlaceSteps - right;
    const int down = v & (kPlaceSteps - 1), up = kPlaceSteps - down;
    const std::uint8_t* above =
        from.pixels + (v >> kPlaceBits) * from.stride + (u >> kPlaceBits) * 3;
    const std::uint8_t* below = above + from.stride;
    for (int k = 0; k < 3; ++k) {
      sum[4 * i + k] += up * (left * above[k] + right * above[k + 3]) +
                        down * (left * below[k] + right * below[k + 3]);
    }
  }
}

#endif

/// Adds 2^14 times the bilinear sample of each pixel to `sum`, four numbers a pixel, the last
/// without meaning.
inline void AddSamples(const SampleSource& from, const SampleRow& row, std::int32_t* sum) {
  row.w == nullptr ? AddSamplesWith<false>(from, row, sum) : AddSamplesWith<true>(from, row, sum);
}

inline void StoreMeans(const std::int32_t* sum, int width, int samples, std::uint8_t* pixels) {
  const float scale =
      1.0F / (static_cast<float>(kPlaceSteps * kPlaceSteps) * static_cast<float>(samples));
  int i = 0;
#ifdef __SSE2__
  // Four bytes are written where three are meant; the next pixel overwrites the last one.
  for (; i + 1 < width; ++i) {
    const __m128i numbers = _mm_loadu_si128(reinterpret_cast<const __m128i*>(sum + 4 * i));
    const __m128 mean = _mm_mul_ps(_mm_cvtepi32_ps(numbers), _mm_set1_ps(scale));
    const __m128i grey = _mm_cvttps_epi32(_mm_add_ps(mean, _mm_set1_ps(0.5F)));
    const __m128i words = _mm_packs_epi32(grey, grey);
    const int bytes = _mm_cvtsi128_si32(_mm_packus_epi16(words, words));
    std::memcpy(pixels + 3 * i, &bytes, sizeof bytes);
  }
#endif
  for (; i < width; ++i) {
    for (int k = 0; k < 3; ++k) {
      const float mean = static_cast<float>(sum[4 * i + k]) * scale;
      pixels[3 * i + k] = static_cast<std::uint8_t>(static_cast<int>(mean + 0.5F));
    }
  }
}

/// A part of the row at a time, whose sums stay in the nearest cache.
inline void Sample(const SampleSource* from, int count, const SampleRow& row,
                   std::uint8_t* pixels) {
  constexpr int kPart = 8 * kRowWidthStep;
  for (int first = 0; first < row.width; first += kPart) {
    const int width = row.width - first < kPart ? row.width - first : kPart;
    const float* w = row.w == nullptr ? nullptr : row.w + first;
    std::int32_t sum[4 * kPart] = {};
    for (int k = 0; k < count; ++k) {
      AddSamples(from[k], {row.x + first, row.y + first, w, width}, sum);
    }
    StoreMeans(sum, width, count, pixels + 3 * first);
  }
}

}  // namespace horopter::sim::portable
