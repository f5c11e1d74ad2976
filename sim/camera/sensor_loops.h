// SPDX-License-Identifier: Apache-2.0
#pragma once

// The sensor's loop of RowKernels for any processor.

#include <cstdint>
#include <cstring>

#include "sim/camera/row_kernels.h"
#include "sim/camera/row_noise.h"

namespace horopter::sim::portable {

/// Four lanes, which compilers turn into whatever vectors there are.
using Words = std::uint32_t __attribute__((vector_size(16)));
using Integers = std::int32_t __attribute__((vector_size(16)));
using Floats = float __attribute__((vector_size(16)));
inline constexpr int kLanes = 4;
inline constexpr int kParts = kRowWidthStep / kLanes;

/// Four normal numbers at a time, one generator per lane.
class Normals {
 public:
  /// @param seed of SeedNoise(), from the first lane of these on
  void Start(const std::uint32_t* seed) {
    for (int k = 0; k < 4; ++k) std::memcpy(&state_[k], seed + k * kRowWidthStep, sizeof(Words));
  }

  Floats Next() {
    const Words t = state_[0] ^ (state_[0] << 11), w = state_[3];
    state_[0] = state_[1], state_[1] = state_[2], state_[2] = w;
    state_[3] = w ^ (w >> 19) ^ t ^ (t >> 8);
    const Words pairs = (state_[3] & 0x00ff00ffU) + ((state_[3] >> 8) & 0x00ff00ffU);
    const Words sum = (pairs & 0xffffU) + (pairs >> 16);
    const Floats s =
        __builtin_convertvector(reinterpret_cast<const Integers&>(sum), Floats) - kNoiseMean;
    const Floats s2 = s * s;
    return s * (kNoise1 + s2 * (kNoise3 + s2 * kNoise5));
  }

 private:
  Words state_[4];
};

/// Of four values, whose loss of gain is `loss`.
template <bool kShot, bool kRead>
inline void ExposeLanes(const SensorRow& sensor, const float* loss, Normals& shot, Normals& read,
                        std::uint8_t* values) {
  Floats lost, sigma;
  std::memcpy(&lost, loss, sizeof lost);
  const Integers grey{values[0], values[1], values[2], values[3]};
  Floats signal = __builtin_convertvector(grey, Floats) * (sensor.gain - lost) * sensor.light;
  // Shot noise first: it follows the light alone.
  if constexpr (kShot) {
    const Floats variance = sensor.shot_gain * signal;
    for (int k = 0; k < kLanes; ++k) sigma[k] = __builtin_sqrtf(variance[k]);
    signal += sigma * shot.Next();
  }
  if constexpr (kRead) signal += sensor.read_noise * read.Next();
  signal = signal * sensor.digits_per_level + 0.5F;
  signal = signal > 0.0F ? signal : Floats{};
  signal = signal < 255.0F ? signal : Floats{255, 255, 255, 255};
  const Integers whole = __builtin_convertvector(signal, Integers);
  for (int k = 0; k < kLanes; ++k) values[k] = static_cast<std::uint8_t>(whole[k]);
}

template <bool kShot, bool kRead>
void ExposeWith(const SensorRow& row, int count, std::uint8_t* values) {
  const SensorRow sensor = row;  // so that no value can be one of its numbers
  Normals shot[kParts], read[kParts];
  std::uint32_t shot_seed[kNoiseWords], read_seed[kNoiseWords];
  SeedNoise(sensor.shot_key, shot_seed);
  SeedNoise(sensor.read_key, read_seed);
  for (int part = 0; part < kParts; ++part) {
    shot[part].Start(shot_seed + part * kLanes);
    read[part].Start(read_seed + part * kLanes);
  }
  const auto expose = [&](int first, std::uint8_t* block) {
    for (int part = 0; part < kParts; ++part) {
      const int k = part * kLanes;
      ExposeLanes<kShot, kRead>(sensor, sensor.loss + first + k, shot[part], read[part], block + k);
    }
  };
  int i = 0;
  for (; i + kRowWidthStep <= count; i += kRowWidthStep) expose(i, values + i);
  if (i == count) return;
  OnPartOfABlock(values + i, count - i, [&](std::uint8_t* block) { expose(i, block); });
}

inline void Expose(const SensorRow& sensor, int count, std::uint8_t* values) {
  const bool shot = sensor.shot_gain > 0, read = sensor.read_noise > 0;
  if (shot && read) return ExposeWith<true, true>(sensor, count, values);
  if (shot) return ExposeWith<true, false>(sensor, count, values);
  if (read) return ExposeWith<false, true>(sensor, count, values);
  return ExposeWith<false, false>(sensor, count, values);
}

}  // namespace horopter::sim::portable
