// SPDX-License-Identifier: Apache-2.0
#pragma once

// The loops of ClosedFormKernels, compiled once for each instruction set (lanes.h). Nothing here
// may call a function of a library that is not inlined: the linker could give its code to all.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "vision/disparity/closed_form_kernels.h"
#include "vision/disparity/lanes.h"

namespace horopter::vision::HOROPTER_KERNELS {

// --- The linear stage ---

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

// --- Scores of hypotheses ---

/// A cell turned in phase by an entry of PhaseTables::turn; up to 127 * 127.
inline S16 Turned(S16 cell, const std::int8_t* turn) {
  return cell * LoadCell(turn) + SwapHalves(cell) * LoadCell(turn + kLanes);
}
/// The same, backwards.
inline S16 TurnedBack(S16 cell, const std::int8_t* turn) {
  return cell * LoadCell(turn) - SwapHalves(cell) * LoadCell(turn + kLanes);
}

inline constexpr int kBlock = 64;  ///< pixels whose matches are looked up together

/// Where sixteen hypotheses of a block of pixels lead.
struct Matches {
  std::array<std::array<std::int32_t, kBlock>, kLanes> pixel;  ///< CellView::outside() = none
  std::array<std::array<std::uint8_t, kBlock>, kLanes> turn;   ///< entry of PhaseTables::turn
};

/// Hypotheses of the pixels from (x, y) on, taken from `candidate`'s neighbours; the image's border
/// is repeated.
inline const std::int16_t* Neighbours(const std::int16_t* hypotheses, const CellView& view, int x,
                                      int y, int count, std::array<std::int16_t, kBlock>& copy) {
  const std::int16_t* row =
      hypotheses + std::int64_t{view.width} * std::clamp(y, 0, view.height - 1);
  if (x >= 0 && x + count <= view.width) return row + x;
  for (int i = 0; i < count; ++i) copy[i] = row[std::clamp(x + i, 0, view.width - 1)];
  return copy.data();
}

inline void FindMatches(const NeighbourTask& t, int x, int y, int count, Matches& out) {
  constexpr int kHalf = kHypothesisSteps / 2;
  const int width = t.right.width, height = t.right.height, outside = t.right.outside();
  std::array<std::int16_t, kBlock> copy_x, copy_y;
  for (int k = 0; k < kLanes; ++k) {
    const Candidates& c = *t.candidates;
    const int from_x = x + c.from_x[k], from_y = y + c.from_y[k];
    const std::int16_t* hx = Neighbours(t.hypothesis_x, t.left, from_x, from_y, count, copy_x);
    const std::int16_t* hy = Neighbours(t.hypothesis_y, t.left, from_x, from_y, count, copy_y);
    const int move_x = c.move_x[k] + kHalf, move_y = c.move_y[k] + kHalf;
    for (int i = 0; i < count; ++i) {
      const int dx = hx[i] + move_x, dy = hy[i] + move_y;  // half a pixel ahead, for rounding
      const int px = x + i + (dx >> 4), py = y + (dy >> 4);
      const bool inside = px >= 0 && px < width && py >= 0 && py < height;
      out.pixel[k][i] = inside ? py * width + px : outside;
      out.turn[k][i] = static_cast<std::uint8_t>((dy & 15) * 16 + (dx & 15));
    }
  }
}

inline void ScoreNeighbours(const NeighbourTask& t, int y) {
  Matches matches;
  for (int x0 = 0; x0 < t.left.width; x0 += kBlock) {
    const int count = std::min(kBlock, t.left.width - x0);
    FindMatches(t, x0, y, count, matches);
    const std::int64_t first = std::int64_t{y} * t.left.width + x0;
    for (int i = 0; i < count; ++i) {
      const S16 left = LoadCell(t.left.at(first + i));
      S32 sums[kLanes];
      for (int k = 0; k < kLanes; ++k) {
        const S16 right = LoadCell(t.right.at(matches.pixel[k][i]));
        sums[k] =
            MulAddPairs(left, Turned(right, &t.tables->turn[matches.turn[k][i] * 2 * kLanes]));
      }
      StoreLanes(t.scores + (first + i) * kLanes, SumEach<kScoreShift>(sums));
    }
  }
}

inline void ScoreShifts(const ShiftTask& t, int y) {
  const int width = t.right.width;
  for (int x = 0; x < t.left.width; ++x) {
    const std::int64_t pixel = std::int64_t{y} * t.left.width + x;
    const int dy = (t.hypothesis_y ? t.hypothesis_y[pixel] : 0) + t.move_y + kHypothesisSteps / 2;
    const int row = y + (dy >> 4);
    std::int16_t* scores = t.scores + pixel * kLanes;
    if (row < 0 || row >= t.right.height) {
      StoreLanes(scores, Splat(0));
      continue;
    }
    // The left cell is turned back by what the match lies between rows, once for all sixteen.
    const S16 left =
        TurnedBack(LoadCell(t.left.at(pixel)), &t.tables->turn[((dy & 15) * 16 + 8) * 2 * kLanes]);
    const int first = x + t.first_dx;
    const std::int32_t at = row * width + first;
    S32 sums[kLanes];
    if (first >= 0 && first + kLanes <= width) {
      for (int k = 0; k < kLanes; ++k) sums[k] = MulAddPairs(left, LoadCell(t.right.at(at + k)));
    } else {
      for (int k = 0; k < kLanes; ++k) {
        const bool inside = first + k >= 0 && first + k < width;
        sums[k] = MulAddPairs(left, LoadCell(t.right.at(inside ? at + k : t.right.outside())));
      }
    }
    StoreLanes(scores, SumEach<kScoreShift>(sums));
  }
}

// --- Pooling ---

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

/// The way back up, one pixel: its lanes are final then.
inline S16 PoolUp(const ColumnPool& p, int x, int y) {
  const std::int64_t row = std::int64_t{p.width} * kLanes;
  std::int16_t* lanes = p.lanes + y * row + x * kLanes;
  // Rows are too far apart for the processor to fetch the next one by itself.
  constexpr int kAhead = 6;
  __builtin_prefetch(lanes - std::min(kAhead, y) * row, 1);
  const S16 own = LoadLanes(lanes);
  if (y + 1 == p.height) return own;
  const S16 below = LoadLanes(lanes + row);
  const std::uint8_t edge = p.edge_y[std::int64_t{y + 1} * p.width + x];
  const S16 pooled = own + MulQ15(below - own, Splat((*p.weights)[edge]));
  StoreLanes(lanes, pooled);
  return pooled;
}

// --- What comes of pooled lanes ---

/// Where the winner of a lane comes from, and what is added to it.
struct Winners {
  std::array<std::ptrdiff_t, kLanes> from;  ///< relative to the pixel, away from the border
  std::array<float, kLanes> add_x, add_y;
};
inline Winners MakeWinners(const KeepTask& t) {
  constexpr float kStep = 1.0F / kHypothesisSteps;
  Winners w;
  for (int k = 0; k < kLanes; ++k) {
    const Candidates* c = t.candidates;
    w.from[k] = c ? std::ptrdiff_t{c->from_y[k]} * t.pool.width + c->from_x[k] : 0;
    w.add_x[k] = c ? kStep * static_cast<float>(c->move_x[k]) : static_cast<float>(t.first_dx + k);
    w.add_y[k] = kStep * static_cast<float>(c ? c->move_y[k] : t.move_y);
  }
  return w;
}

/// Pixels from the border whose candidates all lie inside.
inline int Margin(const KeepTask& t) {
  int margin = 0;
  for (int k = 0; t.candidates && k < kLanes; ++k) {
    margin =
        std::max({margin, std::abs(t.candidates->from_x[k]), std::abs(t.candidates->from_y[k])});
  }
  return margin;
}

/// The pixel that a lane's hypothesis is taken from, where the image's border is repeated.
inline std::int64_t SourceAtBorder(const KeepTask& t, int x, int y, int lane) {
  const int from_x = x + t.candidates->from_x[lane], from_y = y + t.candidates->from_y[lane];
  return std::int64_t{std::clamp(from_y, 0, t.pool.height - 1)} * t.pool.width +
         std::clamp(from_x, 0, t.pool.width - 1);
}

inline void KeepBest(const KeepTask& t, int x_begin, int x_end) {
  const Winners winners = MakeWinners(t);
  const int width = t.pool.width, height = t.pool.height, margin = Margin(t);
  const bool inner_columns = x_begin >= margin && x_end <= width - margin;
  S16 favour{};
  favour[0] = t.favour_own;
  for (int k = t.lanes; k < kLanes; ++k) favour[k] = -16000;  // below every score
  for (int y = height - 1; y >= 0; --y) {
    const bool inner = inner_columns && y >= margin && y < height - margin;
    for (int x = x_begin; x < x_end; ++x) {
      const Greatest found = GreatestLane(PoolUp(t.pool, x, y) + favour);
      const std::int64_t pixel = std::int64_t{y} * width + x;
      if (!t.first && found.value <= t.best[pixel]) continue;
      t.best[pixel] = found.value;
      const int lane = found.lane;
      const std::int64_t from = inner || t.candidates == nullptr ? pixel + winners.from[lane]
                                                                 : SourceAtBorder(t, x, y, lane);
      t.dx[pixel] = (t.old_dx ? t.old_dx[from] : 0.0F) + winners.add_x[lane];
      t.dy[pixel] = (t.old_dy ? t.old_dy[from] : 0.0F) + winners.add_y[lane];
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
  for (int y = t.pool.height - 1; y >= 0; --y) {
    for (int x = x_begin; x < x_end; x += kFloats) {
      const int count = std::min(kFloats, x_end - x);
      for (int i = 0; i < count; ++i) pixels[i] = PoolUp(t.pool, x + i, y);
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

// --- Smoothing ---

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

inline constexpr ClosedFormKernels MakeKernels(std::string_view name) {
  return {name,     FilterRow, ScoreNeighbours, ScoreShifts, MultiplyRow,     PoolRow,
          PoolDown, KeepBest,  Solve,           SmoothRow,   SmoothAcrossRows};
}

}  // namespace horopter::vision::HOROPTER_KERNELS
