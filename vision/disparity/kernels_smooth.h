// SPDX-License-Identifier: Apache-2.0
#pragma once

// Smoothing of a field where it is smooth (closed_form_loops.h says how it is compiled).

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "vision/disparity/closed_form_kernels.h"
#include "vision/disparity/lanes.h"

namespace horopter::vision::HOROPTER_KERNELS {

/// Running mean of what is close to the centre, eight pixels at once.
struct NearMean {
  F32 centre_x, centre_y;
  F32 sum_x = {}, sum_y = {}, count = {};

  void Add(F32 dx, F32 dy, float max_difference) {
    const S32 near =
        (Abs(dx - centre_x) <= max_difference) & (Abs(dy - centre_y) <= max_difference);
    sum_x += near ? dx : SplatFloat(0);
    sum_y += near ? dy : SplatFloat(0);
    count += near ? SplatFloat(1) : SplatFloat(0);
  }
};

inline void StoreMean(const SmoothTask& t, const NearMean& mean, std::int64_t pixel, int count) {
  const F32 x = mean.sum_x / mean.count, y = mean.sum_y / mean.count;
  std::memcpy(t.out_dx + pixel, &x, sizeof(float) * count);
  std::memcpy(t.out_dy + pixel, &y, sizeof(float) * count);
}

inline void SmoothRow(const SmoothTask& t, int y, float* scratch) {
  constexpr float kFar = 1e9F;  // close to no disparity
  const int padded = PaddedRow(t.width, t.radius);
  float *copy_x = scratch, *copy_y = scratch + padded;
  std::fill(scratch, scratch + 2 * padded, kFar);
  const std::int64_t row = std::int64_t{y} * t.width;
  std::copy_n(t.dx + row, t.width, copy_x + t.radius);
  std::copy_n(t.dy + row, t.width, copy_y + t.radius);
  for (int x = 0; x < t.width; x += kFloats) {
    const float *at_x = copy_x + x + t.radius, *at_y = copy_y + x + t.radius;
    NearMean mean{LoadFloats(at_x), LoadFloats(at_y)};
    for (int i = -t.radius; i <= t.radius; ++i) {
      mean.Add(LoadFloats(at_x + i), LoadFloats(at_y + i), t.max_difference_px);
    }
    StoreMean(t, mean, row + x, std::min(kFloats, t.width - x));
  }
}

/// @pre the maps end with kFloats more values than their pixels
inline void SmoothAcrossRows(const SmoothTask& t, int y) {
  const int first = std::max(0, y - t.radius), last = std::min(t.height - 1, y + t.radius);
  for (int x = 0; x < t.width; x += kFloats) {
    const std::int64_t pixel = std::int64_t{y} * t.width + x;
    NearMean mean{LoadFloats(t.dx + pixel), LoadFloats(t.dy + pixel)};
    for (int row = first; row <= last; ++row) {
      const std::int64_t other = std::int64_t{row} * t.width + x;
      mean.Add(LoadFloats(t.dx + other), LoadFloats(t.dy + other), t.max_difference_px);
    }
    StoreMean(t, mean, pixel, std::min(kFloats, t.width - x));
  }
}

}  // namespace horopter::vision::HOROPTER_KERNELS
