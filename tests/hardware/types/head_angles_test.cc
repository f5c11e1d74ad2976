// SPDX-License-Identifier: Apache-2.0
#include "hardware/types/head_angles.h"

#include <gtest/gtest.h>

namespace horopter::hardware {
namespace {

TEST(HeadAngles, ArrayOrderIsTheOrderOfTheAxes) {
  HeadAngles angles;
  angles.neck = {1, 2};
  angles.left = {3, 4};
  angles.right = {5, 6};
  const HeadAxisArray array = ToArray(angles);
  EXPECT_EQ(array[static_cast<int>(HeadAxis::kNeckPan)], 1);
  EXPECT_EQ(array[static_cast<int>(HeadAxis::kNeckTilt)], 2);
  EXPECT_EQ(array[static_cast<int>(HeadAxis::kLeftPan)], 3);
  EXPECT_EQ(array[static_cast<int>(HeadAxis::kLeftTilt)], 4);
  EXPECT_EQ(array[static_cast<int>(HeadAxis::kRightPan)], 5);
  EXPECT_EQ(array[static_cast<int>(HeadAxis::kRightTilt)], 6);
  EXPECT_EQ(ToArray(FromArray(array)), array);
}

TEST(HeadAngles, EyeReachesTheSameAxesAsTheNames) {
  HeadAngles angles;
  angles.eye(Eye::kLeft).pan_rad = 0.1;
  angles.eye(Eye::kRight).tilt_rad = -0.2;
  EXPECT_EQ(angles.left.pan_rad, 0.1);
  EXPECT_EQ(angles.right.tilt_rad, -0.2);
}

TEST(AxisLimits, AnAxisWithoutRangeDoesNotExist) {
  EXPECT_FALSE(AxisLimits{}.exists());
  EXPECT_TRUE((AxisLimits{-1, 1, 2, 3}).exists());
}

}  // namespace
}  // namespace horopter::hardware
