// SPDX-License-Identifier: Apache-2.0
#pragma once

// Scores of hypotheses (closed_form_loops.h says how it is compiled).

#include <algorithm>
#include <array>
#include <cstdint>

#include "vision/disparity/closed_form_kernels.h"
#include "vision/disparity/lanes.h"

namespace horopter::vision::HOROPTER_KERNELS {

/// A cell turned in phase by an entry of PhaseTables::turn; up to sqrt(2) * 127 * 127.
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

}  // namespace horopter::vision::HOROPTER_KERNELS
