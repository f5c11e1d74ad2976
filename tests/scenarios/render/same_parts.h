// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <opencv2/core.hpp>

#include "scenarios/dataset/flo.h"

namespace horopter::scenarios {

/// Pixels that a field says are seen in both pictures show the same part in both, but for those at
/// an outline.
/// @param from, to part ids, CV_16U
/// @param visibility of `from` in `to`: 255 = seen
inline void ExpectSameParts(const cv::Mat& from, const cv::Mat& to, const DisplacementMaps& field,
                            const cv::Mat& visibility) {
  int same = 0, all = 0;
  for (int v = 0; v < from.rows; ++v) {
    for (int u = 0; u < from.cols; ++u) {
      if (visibility.at<uchar>(v, u) != 255) continue;
      const int x = static_cast<int>(std::lround(u + field.dx(v, u)));
      const int y = static_cast<int>(std::lround(v + field.dy(v, u)));
      if (x < 0 || y < 0 || x >= to.cols || y >= to.rows) continue;
      ++all;
      same += to.at<std::uint16_t>(y, x) == from.at<std::uint16_t>(v, u) ? 1 : 0;
    }
  }
  EXPECT_GT(all, from.rows * from.cols / 2);
  EXPECT_GT(same, all * 95 / 100);
}

}  // namespace horopter::scenarios
