// SPDX-License-Identifier: Apache-2.0
#pragma once

// What the instruction sets' loops over a sensor's row share: how bits become normal numbers.

#include <cstdint>

#include "sim/camera/row_kernels.h"
#include "sim/random/random_stream.h"

namespace horopter::sim {

/// The sum s of four random bytes, less its mean, is nearly normal; the odd polynomial
/// s (kNoise1 + kNoise3 s^2 + kNoise5 s^4) straightens it. Its coefficients are the least squares
/// fit to the normal law's quantiles, scaled to a variance of 1. Largest number 4.45; the excess
/// kurtosis is -0.002, and the distribution function is that of the normal law to 0.0008.
inline constexpr float kNoiseMean = 510;
inline constexpr double kNoiseVariance = 21845;       // of s: 4 (256^2 - 1) / 12
inline constexpr double kNoiseDeviation = 147.80053;  // its root
inline constexpr float kNoise1 = static_cast<float>(0.9680293106920386 / kNoiseDeviation);
inline constexpr float kNoise3 =
    static_cast<float>(0.0037220317286309995 / (kNoiseDeviation * kNoiseVariance));
inline constexpr float kNoise5 =
    static_cast<float>(0.0019492674605289767 / (kNoiseDeviation * kNoiseVariance * kNoiseVariance));

/// Words of the generators of a row: four for each lane, one lane for each of kRowWidthStep values.
inline constexpr int kNoiseWords = 4 * kRowWidthStep;

/// Their first state, in the order x, y, z, w of Marsaglia's xorshift (2003), each lane by lane.
inline void SeedNoise(std::uint64_t key, std::uint32_t* words) {
  for (int i = 0; i < kNoiseWords / 2; ++i) {
    const std::uint64_t bits = MixBits(key + static_cast<std::uint64_t>(i));
    words[2 * i] = static_cast<std::uint32_t>(bits);
    words[2 * i + 1] = static_cast<std::uint32_t>(bits >> 32);
  }
}

/// Runs `work` on the last `count` values of a row, fewer than kRowWidthStep.
template <typename Work>
inline void OnPartOfABlock(std::uint8_t* values, int count, Work&& work) {
  std::uint8_t block[kRowWidthStep] = {};
  for (int k = 0; k < count; ++k) block[k] = values[k];
  work(block);
  for (int k = 0; k < count; ++k) values[k] = block[k];
}

}  // namespace horopter::sim
