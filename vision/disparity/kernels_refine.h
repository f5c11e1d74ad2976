// SPDX-License-Identifier: Apache-2.0
#pragma once

// What comes of pooled lanes: the best hypothesis, and the step that products give
// (closed_form_loops.h says how it is compiled).

#include <algorithm>
#include <array>
#include <cstdint>

#include "vision/disparity/closed_form_kernels.h"
#include "vision/disparity/kernels_pool.h"
#include "vision/disparity/lanes.h"

namespace horopter::vision::HOROPTER_KERNELS {

inline void KeepBest(const KeepTask& t, int x_begin, int x_end) {
  S16 counts{}, favour{};
  for (int k = 0; k < kLanes; ++k) {
    counts[k] = k < t.lanes ? -1 : 0;
    favour[k] = k < t.lanes ? 0 : -32768;  // below every score
  }
  favour[0] = t.favour_own;
  RowBelow below;
  for (int y = t.pool.height - 1; y >= 0; --y) {
    for (int x = x_begin; x < x_end; ++x) {
      const S16 scores = (PoolUp(t.pool, x, y, below[x - x_begin]) & counts) + favour;
      const Greatest found = GreatestLane(scores);
      const std::int64_t pixel = std::int64_t{y} * t.pool.width + x;
      const bool better = t.first || found.value > t.best[pixel];
      t.best[pixel] = better ? found.value : t.best[pixel];
      t.winner[pixel] = better ? t.lane_0 + found.lane : t.winner[pixel];
    }
  }
}

/// v turned by a table entry with 15 bits after the point.
inline S16 TurnedFine(S16 v, const std::int16_t* entry) {
  return MulQ15(v, LoadLanes(entry)) + MulQ15(SwapHalves(v), LoadLanes(entry + kLanes));
}

/// The right cell at a position between pixels, with 14 bits: the four around it, each turned to
/// the position before the bilinear average, so that the average does not dampen high frequencies.
inline S16 CellBetween(const CellView& view, const PhaseTables& tables, float x, float y) {
  const int px = static_cast<int>(x), py = static_cast<int>(y);
  const int fx = static_cast<int>((x - static_cast<float>(px)) * 64 + 0.5F);
  const int fy = static_cast<int>((y - static_cast<float>(py)) * 64 + 0.5F);
  const std::int64_t right = px + 1 < view.width ? 1 : 0;
  const std::int64_t below = py + 1 < view.height ? view.width : 0;
  const std::int64_t pixel = std::int64_t{py} * view.width + px;
  const auto weight = [](int of_4096) {
    return Splat(static_cast<std::int16_t>(std::min(8 * of_4096, 32767)));
  };
  const auto cell = [&view](std::int64_t at) { return LoadCell(view.at(at)) << 7; };
  const std::int16_t* corner = tables.from_corner.data();
  const int both = fx * fy;
  const S16 sum =
      MulQ15(cell(pixel), weight(4096 - 64 * fx - 64 * fy + both)) +
      MulQ15(TurnedFine(cell(pixel + right), corner), weight(64 * fx - both)) +
      MulQ15(TurnedFine(cell(pixel + below), corner + 2 * kLanes), weight(64 * fy - both)) +
      MulQ15(TurnedFine(cell(pixel + below + right), corner + 4 * kLanes), weight(both));
  return TurnedFine(TurnedFine(sum, &tables.turn_x[fx * 2 * kLanes]),
                    &tables.turn_y[fy * 2 * kLanes]);
}

inline void MultiplyRow(const ProductTask& t, int y) {
  const auto last_x = static_cast<float>(t.right.width - 1);
  const auto last_y = static_cast<float>(t.right.height - 1);
  for (int x = 0; x < t.left.width; ++x) {
    const std::int64_t pixel = std::int64_t{y} * t.left.width + x;
    const float match_x = static_cast<float>(x) + t.dx[pixel];
    const float match_y = static_cast<float>(y) + t.dy[pixel];
    std::int16_t* out = t.products + pixel * kLanes;
    if (!(match_x >= 0 && match_y >= 0 && match_x <= last_x && match_y <= last_y)) {
      StoreLanes(out, Splat(0));
      continue;
    }
    const S16 right = CellBetween(t.right, *t.tables, match_x, match_y);
    const S16 left = LoadCell(t.left.at(pixel)) << 7;
    const S16 same = MulQ15(left, right);                 // re re, im im
    const S16 crossed = MulQ15(SwapHalves(left), right);  // im re, re im
    StoreLanes(out, LowHalves(same + SwapHalves(same), crossed - SwapHalves(crossed)));
  }
}

/// Intersection of the constraints n.d = phase / (2 pi f0) of eight pixels, each weighted by the
/// magnitude of its pooled product.
struct Steps {
  F32 x, y;
};
inline Steps IntersectConstraints(const SolveTask& t, const S16 (&products)[8]) {
  F32 xx = SplatFloat(0), xy = xx, yy = xx, along_x = xx, along_y = xx;
  for (int o = 0; o < t.orientations; ++o) {
    const F32 re = LowFloats(products[o]), im = HighFloats(products[o]);
    const F32 weight = Sqrt(re * re + im * im);
    const F32 pull = weight * Atan2(im, re) * t.px_per_rad;
    const float nx = t.nx[o], ny = t.ny[o];
    xx += weight * (nx * nx);
    xy += weight * (nx * ny);
    yy += weight * (ny * ny);
    along_x += pull * nx;
    along_y += pull * ny;
  }
  const F32 ridge = t.ridge * (xx + yy) + 1e-6F;
  xx += ridge;
  yy += ridge;
  const F32 inverse = 1.0F / (xx * yy - xy * xy);
  Steps step{(yy * along_x - xy * along_y) * inverse, (xx * along_y - xy * along_x) * inverse};
  const F32 length = Sqrt(step.x * step.x + step.y * step.y);
  const F32 shorten = t.max_step_px / Max(length, SplatFloat(t.max_step_px));
  step.x *= shorten;
  step.y *= shorten;
  return step;
}

inline void Solve(const SolveTask& t, int x_begin, int x_end) {
  S16 pixels[kFloats] = {}, products[kFloats];
  RowBelow below;
  for (int y = t.pool.height - 1; y >= 0; --y) {
    for (int x = x_begin; x < x_end; x += kFloats) {
      const int count = std::min(kFloats, x_end - x);
      for (int i = 0; i < count; ++i) {
        pixels[i] = PoolUp(t.pool, x + i, y, below[x + i - x_begin]);
      }
      Transpose(pixels, products);
      const Steps step = IntersectConstraints(t, products);
      const std::int64_t pixel = std::int64_t{y} * t.pool.width + x;
      for (int i = 0; i < count; ++i) {
        t.dx[pixel + i] += step.x[i];
        t.dy[pixel + i] += step.y[i];
      }
    }
  }
}

}  // namespace horopter::vision::HOROPTER_KERNELS
