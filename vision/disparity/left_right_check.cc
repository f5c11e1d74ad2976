// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/left_right_check.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <opencv2/core.hpp>

namespace horopter::vision {
namespace {

/// Calls `loop(y)` for every row, blocks of them in parallel.
template <typename Loop>
void ForRows(int rows, Loop loop) {
  constexpr int kRowsAtOnce = 32;
  tbb::parallel_for(tbb::blocked_range<int>(0, rows, kRowsAtOnce), [&](const auto& block) {
    for (int y = block.begin(); y < block.end(); ++y) loop(y);
  });
}

/// The pixels of a row; pointers of its own, so that writing `valid` moves nothing else.
struct Row {
  const float *dx, *dy;
  std::uint8_t* valid;
  int width;

  Row(DisparityField& field, int y)
      : dx(field.dx[y]), dy(field.dy[y]), valid(field.valid[y]), width(field.valid.cols) {}
};

/// Clears `valid` where x + dx is not in [border, right], or y + dy not in [border, bottom]. What
/// is left of a difference says both sides of an interval at once, which makes vector instructions.
void KeepInside(const Row& row, int y, float border, float right, float bottom) {
  for (int x = 0; x < row.width; ++x) {
    const float to_x = static_cast<float>(x) + row.dx[x];
    const float to_y = static_cast<float>(y) + row.dy[x];
    const float room_x = std::min(to_x - border, right - to_x);
    const float room_y = std::min(to_y - border, bottom - to_y);
    row.valid[x] = room_x >= 0 ? row.valid[x] : std::uint8_t{0};
    row.valid[x] = room_y >= 0 ? row.valid[x] : std::uint8_t{0};
  }
}

}  // namespace

void CheckLeftRight(const DisparityField& right_to_left, double max_distance_px,
                    DisparityField& left_to_right) {
  const double limit2 = max_distance_px * max_distance_px;
  const DisparityField& back = right_to_left;
  ForRows(left_to_right.valid.rows, [&back, limit2, &left_to_right](int y) {
    const int width = back.valid.cols, height = back.valid.rows;
    const Row row(left_to_right, y);
    for (int x = 0; x < row.width; ++x) {
      const float dx = row.dx[x], dy = row.dy[x];
      const int right_x = cvRound(static_cast<float>(x) + dx);
      const int right_y = cvRound(static_cast<float>(y) + dy);
      const bool inside = right_x >= 0 && right_y >= 0 && right_x < width && right_y < height;
      // Any pixel stands for those outside: a branch that cannot be foretold costs more.
      const int back_x = inside ? right_x : 0, back_y = inside ? right_y : 0;
      const double missed_x = dx + back.dx(back_y, back_x);
      const double missed_y = dy + back.dy(back_y, back_x);
      const bool near = missed_x * missed_x + missed_y * missed_y <= limit2;
      const bool leads_back = inside & near & (back.valid(back_y, back_x) != 0);
      row.valid[x] = leads_back ? row.valid[x] : std::uint8_t{0};
    }
  });
}

void InvalidateOutside(DisparityField& field, int border_px) {
  const int width = field.valid.cols, height = field.valid.rows;
  const auto border = static_cast<float>(border_px);
  const float right = static_cast<float>(width - 1) - border;
  const float bottom = static_cast<float>(height - 1) - border;
  ForRows(height, [&](int y) {
    const Row row(field, y);
    const bool row_inside = y >= border_px && y < height - border_px;
    const int sides = row_inside ? std::min(border_px, width) : width;
    std::fill_n(row.valid, sides, std::uint8_t{0});
    std::fill_n(row.valid + width - sides, sides, std::uint8_t{0});
    KeepInside(row, y, border, right, bottom);
  });
}

void BlankInvalid(DisparityField& field) {
  const cv::Mat1b invalid = field.valid == 0;
  field.dx.setTo(std::numeric_limits<float>::quiet_NaN(), invalid);
  field.dy.setTo(std::numeric_limits<float>::quiet_NaN(), invalid);
  field.confidence.setTo(0, invalid);
}

}  // namespace horopter::vision
