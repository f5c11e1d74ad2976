// SPDX-License-Identifier: Apache-2.0
#pragma once

// The sampling loops of RowKernels for AVX2, eight pixels at a time. Nothing in them may call a
// function of a library that is not inlined: the linker could give its code to all.

#include <immintrin.h>

#include <cstdint>

#include "sim/camera/row_kernels.h"

namespace horopter::sim::avx2 {

/// Where eight samples lie: byte offsets, and for each the weights across, as two bytes twice, and
/// down, as two words.
struct EightPlaces {
  alignas(32) std::int32_t offset[8];
  __m256i across;
  __m256i down;
};

/// Position on an axis, within the image, in steps of a place.
inline __m256i Fixed(__m256 position, float last) {
  const __m256 inside =
      _mm256_min_ps(_mm256_max_ps(position, _mm256_setzero_ps()), _mm256_set1_ps(last));
  return _mm256_cvttps_epi32(
      _mm256_add_ps(_mm256_mul_ps(inside, _mm256_set1_ps(static_cast<float>(kPlaceSteps))),
                    _mm256_set1_ps(0.5F)));
}

inline __m256 Affine(__m256 x, __m256 y, float a, float b, float c) {
  return _mm256_add_ps(
      _mm256_add_ps(_mm256_mul_ps(_mm256_set1_ps(a), x), _mm256_mul_ps(_mm256_set1_ps(b), y)),
      _mm256_set1_ps(c));
}

template <bool kParallax>
inline void FindEight(const SampleSource& from, const SampleRow& row, int i, EightPlaces& to) {
  const float* h = from.h;
  const __m256 x = _mm256_loadu_ps(row.x + i), y = _mm256_loadu_ps(row.y + i);
  __m256 p = Affine(x, y, h[0], h[3], h[6]), q = Affine(x, y, h[1], h[4], h[7]);
  __m256 r = Affine(x, y, h[2], h[5], h[8]);
  if constexpr (kParallax) {
    const __m256 w = _mm256_loadu_ps(row.w + i);
    p = _mm256_add_ps(p, _mm256_mul_ps(w, _mm256_set1_ps(from.e[0])));
    q = _mm256_add_ps(q, _mm256_mul_ps(w, _mm256_set1_ps(from.e[1])));
    r = _mm256_add_ps(r, _mm256_mul_ps(w, _mm256_set1_ps(from.e[2])));
  }
  const __m256 scale = _mm256_div_ps(_mm256_set1_ps(1), r);
  const __m256i u = Fixed(_mm256_mul_ps(p, scale), from.last_x);
  const __m256i v = Fixed(_mm256_mul_ps(q, scale), from.last_y);
  const __m256i one = _mm256_set1_epi32(kPlaceSteps), fraction = _mm256_set1_epi32(kPlaceSteps - 1);
  const __m256i right = _mm256_and_si256(u, fraction), left = _mm256_sub_epi32(one, right);
  const __m256i below = _mm256_and_si256(v, fraction), above = _mm256_sub_epi32(one, below);
  // Column and row as 16 bits of one word, times bytes per pixel and per row.
  const __m256i cell = _mm256_or_si256(_mm256_slli_epi32(_mm256_srli_epi32(u, kPlaceBits), 16),
                                       _mm256_srli_epi32(v, kPlaceBits));
  const __m256i bytes = _mm256_set1_epi32((3 << 16) | from.stride);
  _mm256_store_si256(reinterpret_cast<__m256i*>(to.offset), _mm256_madd_epi16(cell, bytes));
  const __m256i sides = _mm256_or_si256(left, _mm256_slli_epi32(right, 8));
  to.across = _mm256_or_si256(sides, _mm256_slli_epi32(sides, 16));
  to.down = _mm256_or_si256(above, _mm256_slli_epi32(below, 16));
}

/// Eight bytes from a row and eight from the one below.
inline __m128i TwoRows(const std::uint8_t* pixel, int stride) {
  const __m128d above = _mm_load_sd(reinterpret_cast<const double*>(pixel));
  return _mm_castpd_si128(_mm_loadh_pd(above, reinterpret_cast<const double*>(pixel + stride)));
}

/// 2^14 times the samples k and k + 4 of eight, less a bias, four numbers each.
template <int k>
inline __m256i BiasedPair(const SampleSource& from, const EightPlaces& places) {
  constexpr int kAll = k * 0x55;  // number k of each half
  constexpr char kNo = -1;
  const __m256i neighbours =
      _mm256_setr_epi8(0, 3, 1, 4, 2, 5, kNo, kNo, 8, 11, 9, 12, 10, 13, kNo, kNo,  //
                       0, 3, 1, 4, 2, 5, kNo, kNo, 8, 11, 9, 12, 10, 13, kNo, kNo);
  const __m128i first = TwoRows(from.pixels + places.offset[k], from.stride);
  const __m128i second = TwoRows(from.pixels + places.offset[k + 4], from.stride);
  __m256i pixels = _mm256_inserti128_si256(_mm256_castsi128_si256(first), second, 1);
  // A weight may be 128, so it takes the unsigned side of the product and a pixel the signed one.
  pixels = _mm256_xor_si256(_mm256_shuffle_epi8(pixels, neighbours), _mm256_set1_epi8(-128));
  const __m256i rows = _mm256_maddubs_epi16(_mm256_shuffle_epi32(places.across, kAll), pixels);
  const __m256i pairs = _mm256_unpacklo_epi16(rows, _mm256_srli_si256(rows, 8));
  return _mm256_madd_epi16(pairs, _mm256_shuffle_epi32(places.down, kAll));
}
constexpr int kBias = 128 * kPlaceSteps * kPlaceSteps;

/// Writes eight pixels, held as numbers k and k + 4 in `pair[k]`, and four bytes more.
inline void StoreEight(__m256i pair0, __m256i pair1, __m256i pair2, __m256i pair3,
                       std::uint8_t* pixels) {
  constexpr char kNo = -1;
  const __m256i together =
      _mm256_setr_epi8(0, 1, 2, 4, 5, 6, 8, 9, 10, 12, 13, 14, kNo, kNo, kNo, kNo,  //
                       0, 1, 2, 4, 5, 6, 8, 9, 10, 12, 13, 14, kNo, kNo, kNo, kNo);
  const __m256i bytes = _mm256_shuffle_epi8(
      _mm256_packus_epi16(_mm256_packs_epi32(pair0, pair1), _mm256_packs_epi32(pair2, pair3)),
      together);
  _mm_storeu_si128(reinterpret_cast<__m128i*>(pixels), _mm256_castsi256_si128(bytes));
  _mm_storeu_si128(reinterpret_cast<__m128i*>(pixels + 12), _mm256_extracti128_si256(bytes, 1));
}

constexpr int kStored = 28;  ///< bytes that StoreEight() writes

/// Runs eight pixels at a time through `eight(first, target)`, which may write kStored bytes.
template <typename Eight>
inline void ForEights(int width, std::uint8_t* pixels, Eight&& eight) {
  int i = 0;
  for (; 3 * i + kStored <= 3 * width; i += kRowWidthStep) eight(i, pixels + 3 * i);
  for (; i < width; i += kRowWidthStep) {
    std::uint8_t last[kStored];
    eight(i, last);
    const int count = 3 * (width - i < kRowWidthStep ? width - i : kRowWidthStep);
    for (int k = 0; k < count; ++k) pixels[3 * i + k] = last[k];
  }
}

template <bool kParallax>
inline void SampleWith(const SampleSource* from, int count, const SampleRow& row,
                       std::uint8_t* pixels) {
  constexpr float kOne = static_cast<float>(kPlaceSteps * kPlaceSteps);
  const __m256 scale = _mm256_set1_ps(1.0F / (kOne * static_cast<float>(count)));
  const __m256i bias = _mm256_set1_epi32(kBias * count);
  const auto mean = [&](__m256i sum) {
    const __m256 scaled = _mm256_mul_ps(_mm256_cvtepi32_ps(_mm256_add_epi32(sum, bias)), scale);
    return _mm256_cvttps_epi32(_mm256_add_ps(scaled, _mm256_set1_ps(0.5F)));
  };
  ForEights(row.width, pixels, [&](int i, std::uint8_t* to) {
    __m256i sum0 = _mm256_setzero_si256(), sum1 = sum0, sum2 = sum0, sum3 = sum0;
    for (int k = 0; k < count; ++k) {
      EightPlaces places;
      FindEight<kParallax>(from[k], row, i, places);
      sum0 = _mm256_add_epi32(sum0, BiasedPair<0>(from[k], places));
      sum1 = _mm256_add_epi32(sum1, BiasedPair<1>(from[k], places));
      sum2 = _mm256_add_epi32(sum2, BiasedPair<2>(from[k], places));
      sum3 = _mm256_add_epi32(sum3, BiasedPair<3>(from[k], places));
    }
    StoreEight(mean(sum0), mean(sum1), mean(sum2), mean(sum3), to);
  });
}

inline void Sample(const SampleSource* from, int count, const SampleRow& row,
                   std::uint8_t* pixels) {
  row.w == nullptr ? SampleWith<false>(from, count, row, pixels)
                   : SampleWith<true>(from, count, row, pixels);
}

}  // namespace horopter::sim::avx2
