// SPDX-License-Identifier: Apache-2.0
#include "sim/nao/head_limits.h"

#include <gtest/gtest.h>

#include <cmath>

namespace horopter::sim {
namespace {

constexpr double kDegree = M_PI / 180;

TEST(NaoHeadLimits, PitchRangeMeetsTheTableAtItsRowsOnBothSides) {
  const double rows[][3] = {{0, -38.5, 29.51},      {27.85, -38.5, 24.18},  {43.32, -31.4, 21.2},
                            {51.74, -27.5, 18.91},  {62.45, -24.64, 17.19}, {87.49, -18.91, 11.46},
                            {119.52, -25.73, 18.91}};
  for (const auto& [yaw, low, high] : rows) {
    for (const double side : {-1.0, 1.0}) {
      const PitchRange range = NaoPitchRange(side * yaw * kDegree);
      EXPECT_NEAR(range.min_rad, low * kDegree, 1e-9) << yaw;
      EXPECT_NEAR(range.max_rad, high * kDegree, 1e-9) << yaw;
    }
  }
}

TEST(NaoHeadLimits, PitchRangeIsLinearBetweenRowsAndConstantBeyond) {
  const PitchRange between = NaoPitchRange((27.85 + 43.32) / 2 * kDegree);
  EXPECT_NEAR(between.min_rad, (-38.5 - 31.4) / 2 * kDegree, 1e-9);
  EXPECT_NEAR(between.max_rad, (24.18 + 21.2) / 2 * kDegree, 1e-9);
  EXPECT_NEAR(NaoPitchRange(M_PI).max_rad, 18.91 * kDegree, 1e-9);
}

TEST(NaoHeadLimits, ReachableClampsPitchByTheYawThatIsReached) {
  const hardware::HeadAngles reached = NaoReachable({{5, 2}, {1, 1}, {1, 1}});
  EXPECT_DOUBLE_EQ(reached.neck.pan_rad, 2.08567);
  EXPECT_NEAR(reached.neck.tilt_rad, NaoPitchRange(2.08567).max_rad, 1e-12);
  EXPECT_EQ(reached.left.pan_rad, 0);
  EXPECT_EQ(reached.right.tilt_rad, 0);
  const hardware::HeadAngles inside = NaoReachable({{0.4, -0.3}, {}, {}});
  EXPECT_EQ(inside.neck.pan_rad, 0.4);
  EXPECT_EQ(inside.neck.tilt_rad, -0.3);
}

TEST(NaoHeadLimits, PitchNeverExceedsTheJointsRange) {
  for (double yaw = -2.0; yaw <= 2.0; yaw += 0.05) {
    EXPECT_LE(NaoReachable({{yaw, 9}, {}, {}}).neck.tilt_rad, 0.514872);
    EXPECT_GE(NaoReachable({{yaw, -9}, {}, {}}).neck.tilt_rad, -0.671952);
  }
}

}  // namespace
}  // namespace horopter::sim
