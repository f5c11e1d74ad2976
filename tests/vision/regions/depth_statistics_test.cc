// SPDX-License-Identifier: Apache-2.0
#include "vision/regions/depth_statistics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace horopter::vision {
namespace {

TEST(DepthStatistics, OfNothingAreNan) {
  std::vector<float> none;
  const DepthStatistics s = Summarise(none);
  EXPECT_EQ(s.count, 0);
  for (const double value : {s.mean_m, s.min_m, s.deviation_m, s.near_m}) {
    EXPECT_TRUE(std::isnan(value));
  }
}

TEST(DepthStatistics, KnownValues) {
  std::vector<float> depths{4, 2, 4, 4, 5, 5, 7, 9};
  const DepthStatistics s = Summarise(depths);
  EXPECT_EQ(s.count, 8);
  EXPECT_DOUBLE_EQ(s.mean_m, 5);
  EXPECT_DOUBLE_EQ(s.deviation_m, 2);
  EXPECT_DOUBLE_EQ(s.min_m, 2);
  EXPECT_DOUBLE_EQ(s.near_m, 2);  // a twentieth of eight is no pixel
}

TEST(DepthStatistics, AFewWrongPixelsMakeTheMinimumButNotTheNearDistance) {
  std::vector<float> depths(100, 2.0f);
  depths[17] = depths[40] = depths[41] = depths[99] = 0.1f;
  const DepthStatistics s = Summarise(depths);
  EXPECT_FLOAT_EQ(s.min_m, 0.1f);
  EXPECT_FLOAT_EQ(s.near_m, 2.0f);
  depths[0] = 0.1f;  // reordered by now: make six of them wrong whatever their order
  std::fill(depths.begin(), depths.begin() + 6, 0.1f);
  EXPECT_FLOAT_EQ(Summarise(depths).near_m, 0.1f);
}

}  // namespace
}  // namespace horopter::vision
