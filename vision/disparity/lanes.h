// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>

#if defined(__AVX2__)
#include <immintrin.h>
#endif

/// Sixteen 16-bit lanes and eight floats, as the closed form's kernels compute with them.
///
/// Included once by each kernel source, which defines HOROPTER_KERNELS as the name of its
/// instruction set: the same text becomes SSE2, AVX2 and AVX-512 code in a namespace of its own, so
/// that no inline function of one is linked into another. Integer results are the same on all;
/// floats too, since nothing here reorders or fuses operations.
namespace horopter::vision::HOROPTER_KERNELS {

using S16 [[gnu::vector_size(32)]] = std::int16_t;
using S8 [[gnu::vector_size(16)]] = std::int8_t;
using S32 [[gnu::vector_size(32)]] = std::int32_t;
using F32 [[gnu::vector_size(32)]] = float;

inline constexpr int kFloats = 8;

inline S16 LoadLanes(const std::int16_t* p) {
  S16 v;
  std::memcpy(&v, p, sizeof v);
  return v;
}
inline void StoreLanes(std::int16_t* p, S16 v) { std::memcpy(p, &v, sizeof v); }
inline S16 Splat(std::int16_t s) { return S16{} + s; }

inline F32 LoadFloats(const float* p) {
  F32 v;
  std::memcpy(&v, p, sizeof v);
  return v;
}
inline void StoreFloats(float* p, F32 v) { std::memcpy(p, &v, sizeof v); }
inline F32 SplatFloat(float s) { return F32{} + s; }

/// Sixteen bytes as 16-bit lanes.
inline S16 LoadCell(const std::int8_t* p) {
#if defined(__AVX2__)
  return (S16)_mm256_cvtepi8_epi16(_mm_loadu_si128(reinterpret_cast<const __m128i*>(p)));
#else
  S8 v;
  std::memcpy(&v, p, sizeof v);
  return __builtin_convertvector(v, S16);
#endif
}

/// Lanes 8 to 15, then 0 to 7: real and imaginary parts exchanged.
inline S16 SwapHalves(S16 v) {
#if defined(__AVX2__)
  return (S16)_mm256_permute4x64_epi64((__m256i)v, 0x4E);
#else
  return __builtin_shufflevector(v, v, 8, 9, 10, 11, 12, 13, 14, 15, 0, 1, 2, 3, 4, 5, 6, 7);
#endif
}

/// Lanes 0 to 7 of both.
inline S16 LowHalves(S16 a, S16 b) {
#if defined(__AVX2__)
  return (S16)_mm256_permute2x128_si256((__m256i)a, (__m256i)b, 0x20);
#else
  return __builtin_shufflevector(a, b, 0, 1, 2, 3, 4, 5, 6, 7, 16, 17, 18, 19, 20, 21, 22, 23);
#endif
}

/// a * b / 2^15, rounded: the product of fixed-point numbers with 15 bits after the point.
inline S16 MulQ15(S16 a, S16 b) {
#if defined(__AVX2__)
  return (S16)_mm256_mulhrs_epi16((__m256i)a, (__m256i)b);
#else
  S16 product;
  for (int i = 0; i < 16; ++i) {
    product[i] = static_cast<std::int16_t>((std::int32_t{a[i]} * b[i] + (1 << 14)) >> 15);
  }
  return product;
#endif
}

/// Products of lanes, added in pairs.
inline S32 MulAddPairs(S16 a, S16 b) {
#if defined(__AVX2__)
  return (S32)_mm256_madd_epi16((__m256i)a, (__m256i)b);
#else
  S32 sums;
  for (int i = 0; i < 8; ++i) {
    sums[i] = std::int32_t{a[2 * i]} * b[2 * i] + std::int32_t{a[2 * i + 1]} * b[2 * i + 1];
  }
  return sums;
#endif
}

#if defined(__AVX2__)
inline __m256i SumOfEight(const S32* v) {
  const __m256i a = _mm256_hadd_epi32((__m256i)v[0], (__m256i)v[1]);
  const __m256i b = _mm256_hadd_epi32((__m256i)v[2], (__m256i)v[3]);
  const __m256i c = _mm256_hadd_epi32((__m256i)v[4], (__m256i)v[5]);
  const __m256i d = _mm256_hadd_epi32((__m256i)v[6], (__m256i)v[7]);
  const __m256i ab = _mm256_hadd_epi32(a, b);
  const __m256i cd = _mm256_hadd_epi32(c, d);
  return _mm256_add_epi32(_mm256_permute2x128_si256(ab, cd, 0x20),
                          _mm256_permute2x128_si256(ab, cd, 0x31));
}
#endif

/// Lane k: the sum over sums[k], divided by 2^shift towards minus infinity. @pre it fits 16 bits
template <int shift>
inline S16 SumEach(const S32 (&sums)[16]) {
#if defined(__AVX2__)
  const __m256i low = _mm256_srai_epi32(SumOfEight(sums), shift);
  const __m256i high = _mm256_srai_epi32(SumOfEight(sums + 8), shift);
  return (S16)_mm256_permute4x64_epi64(_mm256_packs_epi32(low, high), 0xD8);
#else
  S16 out;
  for (int k = 0; k < 16; ++k) {
    std::int32_t sum = 0;
    for (int i = 0; i < 8; ++i) sum += sums[k][i];
    out[k] = static_cast<std::int16_t>(sum >> shift);
  }
  return out;
#endif
}

struct Greatest {
  int lane;
  std::int16_t value;
};

/// The first of the greatest lanes.
inline Greatest GreatestLane(S16 v) {
#if defined(__AVX2__)
  // The instruction finds the least unsigned number: this turns the order round.
  const __m256i reversed = _mm256_xor_si256((__m256i)v, _mm256_set1_epi16(0x7fff));
  const auto low =
      static_cast<unsigned>(_mm_cvtsi128_si32(_mm_minpos_epu16(_mm256_castsi256_si128(reversed))));
  const auto high = static_cast<unsigned>(
      _mm_cvtsi128_si32(_mm_minpos_epu16(_mm256_extracti128_si256(reversed, 1))));
  const bool in_low = (low & 0xffff) <= (high & 0xffff);
  const unsigned found = in_low ? low : high;
  return {static_cast<int>(found >> 16) + (in_low ? 0 : 8),
          static_cast<std::int16_t>((found & 0xffff) ^ 0x7fff)};
#else
  int best = 0;
  for (int i = 1; i < 16; ++i) {
    if (v[i] > v[best]) best = i;
  }
  return {best, v[best]};
#endif
}

/// Exchanges pixels and lanes of eight pixels: part k of the result has lane k of every pixel, then
/// lane k + 8 of every pixel.
inline void Transpose(const S16 (&pixels)[8], S16 (&lanes)[8]) {
#if defined(__AVX2__)
  __m256i pairs[8], fours[8];
  for (int i = 0; i < 8; i += 2) {
    const auto a = (__m256i)pixels[i], b = (__m256i)pixels[i + 1];
    pairs[i] = _mm256_unpacklo_epi16(a, b);
    pairs[i + 1] = _mm256_unpackhi_epi16(a, b);
  }
  for (int i = 0; i < 8; i += 4) {
    fours[i] = _mm256_unpacklo_epi32(pairs[i], pairs[i + 2]);
    fours[i + 1] = _mm256_unpackhi_epi32(pairs[i], pairs[i + 2]);
    fours[i + 2] = _mm256_unpacklo_epi32(pairs[i + 1], pairs[i + 3]);
    fours[i + 3] = _mm256_unpackhi_epi32(pairs[i + 1], pairs[i + 3]);
  }
  for (int i = 0; i < 4; ++i) {
    lanes[2 * i] = (S16)_mm256_unpacklo_epi64(fours[i], fours[i + 4]);
    lanes[2 * i + 1] = (S16)_mm256_unpackhi_epi64(fours[i], fours[i + 4]);
  }
#else
  for (int k = 0; k < 8; ++k) {
    for (int i = 0; i < 8; ++i) {
      lanes[k][i] = pixels[i][k];
      lanes[k][8 + i] = pixels[i][8 + k];
    }
  }
#endif
}

/// Lanes 0 to 7, or 8 to 15, as floats.
inline F32 LowFloats(S16 v) {
#if defined(__AVX2__)
  return (F32)_mm256_cvtepi32_ps(_mm256_cvtepi16_epi32(_mm256_castsi256_si128((__m256i)v)));
#else
  F32 out;
  for (int i = 0; i < kFloats; ++i) out[i] = v[i];
  return out;
#endif
}
inline F32 HighFloats(S16 v) { return LowFloats(SwapHalves(v)); }

inline F32 Sqrt(F32 v) {
#if defined(__AVX2__)
  return (F32)_mm256_sqrt_ps((__m256)v);
#else
  F32 root;
  for (int i = 0; i < kFloats; ++i) root[i] = std::sqrt(v[i]);
  return root;
#endif
}

inline F32 Abs(F32 v) { return v < 0 ? -v : v; }
inline F32 Min(F32 a, F32 b) { return a < b ? a : b; }
inline F32 Max(F32 a, F32 b) { return a > b ? a : b; }

/// The angle of (x, y) [rad], within 1e-4; 0 for (0, 0). The polynomial is a minimax fit of the
/// arc tangent on [0, 1].
inline F32 Atan2(F32 y, F32 x) {
  const F32 ax = Abs(x), ay = Abs(y);
  const F32 t = Min(ax, ay) / (Max(ax, ay) + 1e-20F);
  const F32 s = t * t;
  F32 angle = (((-0.0464964749F * s + 0.15931422F) * s - 0.327622764F) * s) * t + t;
  angle = ay > ax ? 1.57079637F - angle : angle;
  angle = x < 0 ? 3.14159274F - angle : angle;
  return y < 0 ? -angle : angle;
}

}  // namespace horopter::vision::HOROPTER_KERNELS
