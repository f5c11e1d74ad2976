// SPDX-License-Identifier: Apache-2.0
#pragma once

// Pooling (closed_form_loops.h says how it is compiled).

#include <algorithm>
#include <array>
#include <cstdint>

#include "vision/disparity/closed_form_kernels.h"
#include "vision/disparity/lanes.h"

namespace horopter::vision::HOROPTER_KERNELS {

/// The recursive filter along a row, there and back (Gastal & Oliveira, SIGGRAPH 2011).
inline void PoolRow(std::int16_t* row, const std::uint8_t* edge_x, const PoolingWeights& weights,
                    int width) {
  S16 pooled = LoadLanes(row);
  for (int x = 1; x < width; ++x) {
    const S16 own = LoadLanes(row + x * kLanes);
    pooled = own + MulQ15(pooled - own, Splat(weights[edge_x[x]]));
    StoreLanes(row + x * kLanes, pooled);
  }
  for (int x = width - 2; x >= 0; --x) {
    const S16 own = LoadLanes(row + x * kLanes);
    pooled = own + MulQ15(pooled - own, Splat(weights[edge_x[x + 1]]));
    StoreLanes(row + x * kLanes, pooled);
  }
}

inline void PoolDown(const ColumnPool& p, int y_begin, int y_end, int x_begin, int x_end) {
  const std::int64_t row = std::int64_t{p.width} * kLanes;
  for (int y = std::max(1, y_begin); y < y_end; ++y) {
    const std::uint8_t* edge = p.edge_y + std::int64_t{y} * p.width;
    for (int x = x_begin; x < x_end; ++x) {
      std::int16_t* lanes = p.lanes + y * row + x * kLanes;
      const S16 own = LoadLanes(lanes), above = LoadLanes(lanes - row);
      StoreLanes(lanes, own + MulQ15(above - own, Splat((*p.weights)[edge[x]])));
    }
  }
}

/// Final lanes of the row below, for the columns of a block.
using RowBelow = std::array<S16, kColumnsAtOnce>;

/// The way back up, one pixel: its lanes are final then. They are not written back: the only one
/// that needs them again is the pixel above, which finds them in `below`.
/// @param below of this column; then this pixel's
inline S16 PoolUp(const ColumnPool& p, int x, int y, S16& below) {
  const std::int64_t row = std::int64_t{p.width} * kLanes;
  const std::int16_t* lanes = p.lanes + y * row + x * kLanes;
  // Rows are too far apart for the processor to fetch the next one by itself.
  constexpr int kAhead = 6;
  __builtin_prefetch(lanes - std::min(kAhead, y) * row);
  const S16 own = LoadLanes(lanes);
  if (y + 1 == p.height) {
    below = own;
  } else {
    const std::uint8_t edge = p.edge_y[std::int64_t{y + 1} * p.width + x];
    below = own + MulQ15(below - own, Splat((*p.weights)[edge]));
  }
  return below;
}

}  // namespace horopter::vision::HOROPTER_KERNELS
