// SPDX-License-Identifier: Apache-2.0
#include "control/base/unicycle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace horopter::control {
namespace {

using hardware::Pose2;

const hardware::BaseProperties kKoala{4.5e-5, 0.31, 0.571};

TEST(Unicycle, TwistRoundTrip) {
  for (const double v : {-0.2, 0.0, 0.3}) {
    for (const double w : {-1.0, 0.0, 0.5}) {
      const hardware::Twist2 back = ToTwist(FromTwist({v, w}, kKoala), kKoala);
      EXPECT_NEAR(back.forward_m_s, v, 1e-12);
      EXPECT_NEAR(back.turn_rad_s, w, 1e-12);
    }
  }
}

TEST(Unicycle, TurningLeftDrivesTheRightWheels) {
  const hardware::WheelSpeeds speeds = FromTwist({0, 1}, kKoala);
  EXPECT_DOUBLE_EQ(speeds.right_m_s, 0.155);
  EXPECT_DOUBLE_EQ(speeds.left_m_s, -0.155);
}

TEST(Unicycle, ExcessSpeedIsScaledWithTheCurvatureKept) {
  const hardware::WheelSpeeds speeds = FromTwist({2, 1}, kKoala);
  EXPECT_DOUBLE_EQ(speeds.right_m_s, 0.571);
  const hardware::Twist2 back = ToTwist(speeds, kKoala);
  EXPECT_NEAR(back.turn_rad_s / back.forward_m_s, 0.5, 1e-12);
}

TEST(Unicycle, QuarterCircleEndsWhereACompassPutsIt) {
  const double radius = 0.7;
  const Pose2 end = AlongArc({1, 2, M_PI / 2}, radius * M_PI / 2, M_PI / 2);
  EXPECT_NEAR(end.x_m, 1 - radius, 1e-12);
  EXPECT_NEAR(end.y_m, 2 + radius, 1e-12);
  EXPECT_NEAR(end.heading_rad, M_PI, 1e-12);
}

TEST(Unicycle, ArcsAddUp) {
  Pose2 stepped{0.3, -0.2, 0.4};
  for (int i = 0; i < 1000; ++i) stepped = AlongArc(stepped, 0.002, -0.001);
  const Pose2 whole = AlongArc({0.3, -0.2, 0.4}, 2, -1);
  EXPECT_NEAR(stepped.x_m, whole.x_m, 1e-10);
  EXPECT_NEAR(stepped.y_m, whole.y_m, 1e-10);
  EXPECT_NEAR(stepped.heading_rad, whole.heading_rad, 1e-10);
}

TEST(Unicycle, AlmostStraightIsContinuous) {
  for (const double turn : {1e-5, 1.9e-4, 2.1e-4}) {
    const Pose2 end = AlongArc({}, 1, turn);
    EXPECT_NEAR(end.x_m, std::sin(turn) / turn, 1e-12);
    EXPECT_NEAR(end.y_m, (1 - std::cos(turn)) / turn, 1e-11);
  }
}

TEST(Unicycle, ValidateNamesEveryBadField) {
  EXPECT_TRUE(Validate(kKoala).empty());
  EXPECT_EQ(Validate({0, -1, std::numeric_limits<double>::quiet_NaN()}).size(), 3u);
}

}  // namespace
}  // namespace horopter::control
