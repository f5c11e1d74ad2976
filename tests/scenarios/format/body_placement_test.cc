// SPDX-License-Identifier: Apache-2.0
#include "scenarios/format/body_placement.h"

#include <gtest/gtest.h>

#include <cmath>

namespace horopter::scenarios {
namespace {

using Eigen::Vector3d;

TEST(BodyPlacement, YawIsCounterClockwisePitchFrontDownRollLeftSideUp) {
  const Vector3d front(1, 0, 0), left(0, 1, 0);
  EXPECT_TRUE(
      (BodyPlacement{Vector3d::Zero(), 90, 0, 0}.X_OBody().linear() * front).isApprox(left));
  EXPECT_LT((BodyPlacement{Vector3d::Zero(), 0, 30, 0}.X_OBody().linear() * front).z(), -0.49);
  EXPECT_GT((BodyPlacement{Vector3d::Zero(), 0, 0, 30}.X_OBody().linear() * left).z(), 0.49);
}

TEST(BodyPlacement, RollTurnsAboutTheBodysOwnAxisOfAllThree) {
  const BodyPlacement level{{1, 2, 3}, 40, 25, 0};
  BodyPlacement rolled = level;
  rolled.roll_deg = 70;
  EXPECT_TRUE(rolled.X_OBody().linear().col(0).isApprox(level.X_OBody().linear().col(0)))
      << "the x axis stays where yaw and pitch have put it";
  EXPECT_EQ(rolled.X_OBody().translation(), Vector3d(1, 2, 3));
  EXPECT_NEAR(rolled.X_OBody().linear().determinant(), 1, 1e-12);
}

}  // namespace
}  // namespace horopter::scenarios
