// SPDX-License-Identifier: Apache-2.0
#include "control/kinematics/gaze_angles.h"

#include <gtest/gtest.h>

#include <cmath>

#include "control/kinematics/head_kinematics.h"
#include "tests/control/kinematics/heads.h"

namespace horopter::control {
namespace {

hardware::HeadLimits Limits(bool neck) {
  hardware::HeadLimits limits{};
  if (neck) limits[0] = limits[1] = {-1, 1, 5, 50};
  limits[2] = limits[4] = {-1, 1, 5, 50};
  if (!neck) limits[3] = limits[5] = {-0.5, 0.5, 5, 50};
  return limits;
}

TEST(Turn, VergenceIsTheAngleBetweenTheOpticalAxes) {
  for (const bool neck : {false, true}) {
    const Fixation turned = Turn({{0.3, 0.1}, 0.2}, Limits(neck));
    ASSERT_TRUE(turned.reachable());
    const auto geometry = neck ? YorickHead() : KoalaHead();
    const Eigen::Vector3d left =
        EyePose(geometry, turned.angles, hardware::Eye::kLeft).linear().col(2);
    const Eigen::Vector3d right =
        EyePose(geometry, turned.angles, hardware::Eye::kRight).linear().col(2);
    // Eyes that tilt after they pan are a little less apart in space than in pan.
    EXPECT_NEAR(std::acos(left.dot(right)), 0.2, neck ? 1e-9 : 2e-3);
    EXPECT_LT(left.y(), right.y());  // the left eye looks further right
  }
}

TEST(Turn, BeyondTheLimitsIsClampedAndSaid) {
  const Fixation turned = Turn({{0.95, 0}, 0.2}, Limits(false));
  EXPECT_EQ(turned.fault, FixationFault::kBeyondLimits);
  EXPECT_EQ(turned.axis, hardware::HeadAxis::kRightPan);
  EXPECT_EQ(turned.angles.right.pan_rad, 1);
}

}  // namespace
}  // namespace horopter::control
