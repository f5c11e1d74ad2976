// SPDX-License-Identifier: Apache-2.0
#pragma once

// The linear stage (closed_form_loops.h says how it is compiled).

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "vision/disparity/closed_form_kernels.h"
#include "vision/disparity/lanes.h"

namespace horopter::vision::HOROPTER_KERNELS {

/// Even and odd filter of a row or column at eight pixels, from the taps at and after the centre.
struct EvenOdd {
  F32 even, odd;
};
inline EvenOdd FilterBoth(const float* centre, std::ptrdiff_t step, const float* even,
                          const float* odd, int radius) {
  EvenOdd out{even[0] * LoadFloats(centre), SplatFloat(0)};
  for (int t = 1; t <= radius; ++t) {
    const F32 before = LoadFloats(centre - t * step), after = LoadFloats(centre + t * step);
    out.even += even[t] * (after + before);
    out.odd += odd[t] * (after - before);
  }
  return out;
}

/// The image's rows y - radius to y + radius through the filters along y: two padded rows (even,
/// odd) for each frequency.
inline void FilterAlongY(const FilterTask& t, int y, int stride, float* planes) {
  std::array<const float*, 65> rows;
  for (int i = -t.radius; i <= t.radius; ++i) {
    rows[i + t.radius] = t.grey + std::ptrdiff_t{t.width} * std::clamp(y + i, 0, t.height - 1);
  }
  const int taps = t.radius + 1, frequencies = t.orientations / 2 + 1;
  for (int x = 0; x < t.width; x += kFloats) {
    std::array<F32, 33> sum, difference;
    sum[0] = LoadFloats(rows[t.radius] + x);
    for (int i = 1; i <= t.radius; ++i) {
      const F32 above = LoadFloats(rows[t.radius - i] + x),
                below = LoadFloats(rows[t.radius + i] + x);
      sum[i] = below + above;
      difference[i] = below - above;
    }
    for (int k = 0; k < frequencies; ++k) {
      F32 even = t.even[k * taps] * sum[0], odd = SplatFloat(0);
      for (int i = 1; i <= t.radius; ++i) {
        even += t.even[k * taps + i] * sum[i];
        odd += t.odd[k * taps + i] * difference[i];
      }
      StoreFloats(planes + std::ptrdiff_t{stride} * 2 * k + t.radius + x, even);
      StoreFloats(planes + std::ptrdiff_t{stride} * (2 * k + 1) + t.radius + x, odd);
    }
  }
  for (int p = 0; p < 2 * frequencies; ++p) {
    float* row = planes + std::ptrdiff_t{stride} * p;
    std::fill(row, row + t.radius, row[t.radius]);
    std::fill(row + t.radius + t.width, row + stride, row[t.radius + t.width - 1]);
  }
}

/// Real and imaginary parts of every orientation at eight pixels.
struct Responses {
  std::array<F32, kMaxCellOrientations> re, im;
};
inline Responses FilterAlongX(const FilterTask& t, int stride, const float* planes, int x) {
  Responses out;
  const int taps = t.radius + 1, half = t.orientations / 2;
  const float* centre = planes + t.radius + x;
  const F32 blurred =
      FilterBoth(centre, 1, t.across_even + half * taps, t.across_odd + half * taps, t.radius).even;
  for (int i = 0; i <= half; ++i) {
    const float* kx_even = t.across_even + i * taps;
    const float* kx_odd = t.across_odd + i * taps;
    const EvenOdd of_even =
        FilterBoth(centre + std::ptrdiff_t{stride} * 2 * i, 1, kx_even, kx_odd, t.radius);
    const EvenOdd of_odd =
        FilterBoth(centre + std::ptrdiff_t{stride} * (2 * i + 1), 1, kx_even, kx_odd, t.radius);
    const F32 balanced = of_even.even - t.balance[i] * blurred;
    const int mirror = (t.orientations - i) % t.orientations;
    out.re[mirror] = balanced + of_odd.odd;
    out.im[mirror] = of_odd.even - of_even.odd;
    out.re[i] = balanced - of_odd.odd;
    out.im[i] = of_even.odd + of_odd.even;
  }
  return out;
}

/// Divisive normalisation, of each orientation and then of the whole cell.
inline void Normalise(const FilterTask& t, Responses& r) {
  F32 power = SplatFloat(t.floor);
  for (int o = 0; o < t.orientations; ++o) {
    const F32 gain = 1.0F / Sqrt(r.re[o] * r.re[o] + r.im[o] * r.im[o] + t.saturation2);
    r.re[o] *= gain;
    r.im[o] *= gain;
    power += r.re[o] * r.re[o] + r.im[o] * r.im[o];
  }
  const F32 gain = static_cast<float>(kCellOne) * Sqrt(static_cast<float>(kCellPower) / power);
  for (int o = 0; o < t.orientations; ++o) {
    r.re[o] *= gain;
    r.im[o] *= gain;
  }
}

/// Rounded, within +-127, as the lowest byte.
inline S32 ToByte(F32 v) {
  const F32 limit = SplatFloat(static_cast<float>(kCellOne));
  const F32 bounded = Min(Max(v, -limit), limit);
  return (__builtin_convertvector(bounded + 128.5F, S32) - 128) & 255;
}

/// Eight cells. @param count how many of them to write
inline void PackCells(const FilterTask& t, const Responses& r, int count, std::int8_t* cells) {
  std::array<std::array<std::int32_t, kFloats>, 4> words;  // four bytes of each of eight cells
  for (int word = 0; word < 4; ++word) {
    S32 packed{};
    for (int byte = 0; byte < 4; ++byte) {
      const int lane = 4 * word + byte, o = lane % kMaxCellOrientations;
      if (o >= t.orientations) continue;
      const F32 value = lane < kMaxCellOrientations ? r.re[o] : r.im[o];
      packed |= ToByte(value) << (8 * byte);
    }
    std::memcpy(words[word].data(), &packed, sizeof packed);
  }
  for (int i = 0; i < count; ++i) {
    const std::array<std::int32_t, 4> cell = {words[0][i], words[1][i], words[2][i], words[3][i]};
    std::memcpy(cells + i * kLanes, cell.data(), sizeof cell);
  }
}

inline void FilterRow(const FilterTask& t, int y, float* planes) {
  const int stride = PaddedRow(t.width, t.radius);
  FilterAlongY(t, y, stride, planes);
  std::int8_t* cells = t.cells + std::int64_t{y} * t.width * kLanes;
  for (int x = 0; x < t.width; x += kFloats) {
    Responses r = FilterAlongX(t, stride, planes, x);
    Normalise(t, r);
    PackCells(t, r, std::min(kFloats, t.width - x), cells + std::int64_t{x} * kLanes);
  }
}

}  // namespace horopter::vision::HOROPTER_KERNELS
