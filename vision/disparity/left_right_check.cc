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

void InvalidateOutside(DisparityField& field) {
  const auto right = static_cast<float>(field.valid.cols - 1);
  const auto bottom = static_cast<float>(field.valid.rows - 1);
  for (int y = 0; y < field.valid.rows; ++y) {
    for (int x = 0; x < field.valid.cols; ++x) {
      const float match_x = static_cast<float>(x) + field.dx(y, x);
      const float match_y = static_cast<float>(y) + field.dy(y, x);
      const bool inside = match_x >= 0 && match_y >= 0 && match_x <= right && match_y <= bottom;
      if (!inside) field.valid(y, x) = 0;
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
