// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/left_right_check.h"

#include <cmath>
#include <limits>
#include <opencv2/core.hpp>

namespace horopter::vision {

void CheckLeftRight(const DisparityField& right_to_left, double max_distance_px,
                    DisparityField& left_to_right) {
  const DisparityField& back = right_to_left;
  DisparityField& there = left_to_right;
  const double limit2 = max_distance_px * max_distance_px;
  for (int y = 0; y < there.valid.rows; ++y) {
    for (int x = 0; x < there.valid.cols; ++x) {
      if (there.valid(y, x) == 0) continue;
      const float dx = there.dx(y, x);
      const float dy = there.dy(y, x);
      const int right_x = cvRound(static_cast<float>(x) + dx);
      const int right_y = cvRound(static_cast<float>(y) + dy);
      const bool inside =
          right_x >= 0 && right_y >= 0 && right_x < back.valid.cols && right_y < back.valid.rows;
      if (inside && back.valid(right_y, right_x) != 0) {
        const double missed_x = dx + back.dx(right_y, right_x);
        const double missed_y = dy + back.dy(right_y, right_x);
        if (missed_x * missed_x + missed_y * missed_y <= limit2) continue;
      }
      there.valid(y, x) = 0;
    }
  }
}

void InvalidateOutside(DisparityField& field, int border_px) {
  const auto border = static_cast<float>(border_px);
  const float right = static_cast<float>(field.valid.cols - 1) - border;
  const float bottom = static_cast<float>(field.valid.rows - 1) - border;
  const auto inside = [&](float x, float y) {
    return x >= border && y >= border && x <= right && y <= bottom;
  };
  for (int y = 0; y < field.valid.rows; ++y) {
    for (int x = 0; x < field.valid.cols; ++x) {
      const auto from_x = static_cast<float>(x), from_y = static_cast<float>(y);
      const bool both =
          inside(from_x, from_y) && inside(from_x + field.dx(y, x), from_y + field.dy(y, x));
      if (!both) field.valid(y, x) = 0;
    }
  }
}

void BlankInvalid(DisparityField& field) {
  const cv::Mat1b invalid = field.valid == 0;
  field.dx.setTo(std::numeric_limits<float>::quiet_NaN(), invalid);
  field.dy.setTo(std::numeric_limits<float>::quiet_NaN(), invalid);
  field.confidence.setTo(0, invalid);
}

}  // namespace horopter::vision
