// SPDX-License-Identifier: Apache-2.0
#pragma once

// The sensor's loop of RowKernels for AVX2. Nothing in it may call a function of a library that is
// not inlined: the linker could give its code to all.

#include <immintrin.h>

#include <cstdint>

#include "sim/camera/row_kernels.h"
#include "sim/camera/row_noise.h"

namespace horopter::sim::avx2 {

/// Eight normal numbers at a time, one generator per lane.
class Normals {
 public:
  explicit Normals(std::uint64_t key) {
    alignas(32) std::uint32_t seed[kNoiseWords];
    SeedNoise(key, seed);
    const __m256i* words = reinterpret_cast<const __m256i*>(seed);
    x_ = words[0], y_ = words[1], z_ = words[2], w_ = words[3];
  }

  __m256 Next() {
    const __m256i t = _mm256_xor_si256(x_, _mm256_slli_epi32(x_, 11));
    x_ = y_, y_ = z_, z_ = w_;
    w_ = _mm256_xor_si256(_mm256_xor_si256(w_, _mm256_srli_epi32(w_, 19)),
                          _mm256_xor_si256(t, _mm256_srli_epi32(t, 8)));
    const __m256i pairs = _mm256_maddubs_epi16(w_, _mm256_set1_epi8(1));
    const __m256i sum = _mm256_madd_epi16(pairs, _mm256_set1_epi16(1));
    const __m256 s = _mm256_sub_ps(_mm256_cvtepi32_ps(sum), _mm256_set1_ps(kNoiseMean));
    const __m256 s2 = _mm256_mul_ps(s, s);
    const __m256 bent =
        _mm256_add_ps(_mm256_set1_ps(kNoise3), _mm256_mul_ps(s2, _mm256_set1_ps(kNoise5)));
    return _mm256_mul_ps(s, _mm256_add_ps(_mm256_set1_ps(kNoise1), _mm256_mul_ps(s2, bent)));
  }

 private:
  __m256i x_, y_, z_, w_;
};

/// Of eight values, whose loss of gain is `loss`.
template <bool kShot, bool kRead>
inline void ExposeBlock(const SensorRow& sensor, __m256 loss, Normals& shot, Normals& read,
                        std::uint8_t* block) {
  const __m128i bytes = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(block));
  const __m256 grey = _mm256_cvtepi32_ps(_mm256_cvtepu8_epi32(bytes));
  const __m256 gain = _mm256_sub_ps(_mm256_set1_ps(sensor.gain), loss);
  __m256 signal = _mm256_mul_ps(_mm256_mul_ps(grey, gain), _mm256_set1_ps(sensor.light));
  // Shot noise first: it follows the light alone.
  if constexpr (kShot) {
    const __m256 sigma = _mm256_sqrt_ps(_mm256_mul_ps(_mm256_set1_ps(sensor.shot_gain), signal));
    signal = _mm256_add_ps(signal, _mm256_mul_ps(sigma, shot.Next()));
  }
  if constexpr (kRead) {
    signal = _mm256_add_ps(signal, _mm256_mul_ps(_mm256_set1_ps(sensor.read_noise), read.Next()));
  }
  const __m256 digits = _mm256_mul_ps(signal, _mm256_set1_ps(sensor.digits_per_level));
  const __m256 up = _mm256_max_ps(_mm256_add_ps(digits, _mm256_set1_ps(0.5F)), _mm256_setzero_ps());
  const __m256i whole = _mm256_cvttps_epi32(_mm256_min_ps(up, _mm256_set1_ps(255)));
  const __m128i words =
      _mm_packs_epi32(_mm256_castsi256_si128(whole), _mm256_extracti128_si256(whole, 1));
  _mm_storel_epi64(reinterpret_cast<__m128i*>(block), _mm_packus_epi16(words, words));
}

template <bool kShot, bool kRead>
inline void ExposeWith(const SensorRow& row, int count, std::uint8_t* values) {
  const SensorRow sensor = row;  // so that no value can be one of its numbers
  Normals shot(sensor.shot_key), read(sensor.read_key);
  int i = 0;
  for (; i + kRowWidthStep <= count; i += kRowWidthStep) {
    ExposeBlock<kShot, kRead>(sensor, _mm256_loadu_ps(sensor.loss + i), shot, read, values + i);
  }
  if (i == count) return;
  OnPartOfABlock(values + i, count - i, [&](std::uint8_t* block) {
    ExposeBlock<kShot, kRead>(sensor, _mm256_loadu_ps(sensor.loss + i), shot, read, block);
  });
}

inline void Expose(const SensorRow& sensor, int count, std::uint8_t* values) {
  const bool shot = sensor.shot_gain > 0, read = sensor.read_noise > 0;
  if (shot && read) return ExposeWith<true, true>(sensor, count, values);
  if (shot) return ExposeWith<true, false>(sensor, count, values);
  if (read) return ExposeWith<false, true>(sensor, count, values);
  return ExposeWith<false, false>(sensor, count, values);
}

}  // namespace horopter::sim::avx2
