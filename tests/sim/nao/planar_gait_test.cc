// SPDX-License-Identifier: Apache-2.0
#include "sim/nao/planar_gait.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "sim/nao/leg_ik.h"

namespace horopter::sim {
namespace {

using hardware::Eye;
using hardware::Pose2;

constexpr double kTick_s = 0.002;
const hardware::Duration kTick = hardware::FromSeconds(kTick_s);

NaoGaitConfig WithoutSlip() {
  NaoGaitConfig config;
  config.slip_gain = config.slip_step = config.slip_turn_rad = 0;
  return config;
}

/// Advances until the robot stands. @return the time it took [s]
double Walk(PlanarGait& gait, double most_s = 120) {
  double t = 0;
  for (; gait.walking() && t < most_s; t += kTick_s) gait.Advance();
  EXPECT_FALSE(gait.walking());
  return t;
}

void ExpectPose(const Pose2& got, const Pose2& wanted, double length_m, double angle_rad) {
  EXPECT_NEAR(got.x_m, wanted.x_m, length_m);
  EXPECT_NEAR(got.y_m, wanted.y_m, length_m);
  EXPECT_NEAR(hardware::WrapAngle(got.heading_rad - wanted.heading_rad), 0, angle_rad);
}

TEST(PlanarGait, SpeedLimitsFollowFromTheStepLimits) {
  const hardware::WalkVelocity most = NaoGaitConfig().MaxVelocity();
  EXPECT_NEAR(most.forward_m_s, 0.0952, 5e-5);
  EXPECT_NEAR(most.left_m_s, 0.06 / 0.84, 1e-12);
  EXPECT_NEAR(most.turn_rad_s, 0.35 / 0.84, 1e-12);
}

TEST(PlanarGait, ArrivesAtItsTargetWithFeetTogether) {
  for (const Pose2& target :
       {Pose2{0.5, 0, 0}, Pose2{-0.2, 0, 0}, Pose2{0, 0.15, 0}, Pose2{0, 0, M_PI},
        Pose2{0, 0, -1.2}, Pose2{0.4, 0.3, 0.9}, Pose2{0.003, 0, 0}, Pose2{0.3, -0.2, -2.5}}) {
    PlanarGait gait(WithoutSlip(), 1, kTick);
    gait.MoveTo(target);
    Walk(gait);
    ExpectPose(gait.odometry(), target, 1e-6, 1e-6);
    const hardware::Pose X_WB = gait.X_WB();
    EXPECT_TRUE(X_WB.isApprox(hardware::ToPose(target), 1e-6));
    for (const Eye side : hardware::kBothEyes) {
      const double y = side == Eye::kLeft ? NaoLeg::kHipAside_m : -NaoLeg::kHipAside_m;
      const hardware::Pose X_BF = X_WB.inverse() * gait.X_WF(side);
      EXPECT_LT((X_BF.translation() - Eigen::Vector3d(0, y, 0)).norm(), 1e-9);
    }
  }
}

TEST(PlanarGait, TargetsAddUpAndAreRelativeToWhereItIs) {
  PlanarGait gait(WithoutSlip(), 1, kTick);
  for (int side = 0; side < 4; ++side) {
    gait.MoveTo({0.2, 0, M_PI / 2});
    Walk(gait);
  }
  ExpectPose(gait.odometry(), {0, 0, 0}, 1e-5, 1e-5);
}

TEST(PlanarGait, ANewTargetOnTheWayReplacesTheOldOne) {
  PlanarGait gait(WithoutSlip(), 1, kTick);
  gait.MoveTo({1, 0, 0});
  for (int i = 0; i < 800; ++i) gait.Advance();
  const Pose2 there = gait.odometry();
  gait.MoveTo({0, 0.1, 0.3});
  Walk(gait);
  ExpectPose(gait.odometry(), {there.x_m, there.y_m + 0.1, 0.3}, 1e-5, 1e-5);
}

TEST(PlanarGait, VelocitiesBeyondTheMaximumAreScaledDownTogether) {
  PlanarGait gait(WithoutSlip(), 1, kTick);
  gait.Move({0.0952 * 10 / 4, 0, 0.35 / 0.84 * 10});
  for (int i = 0; i < 210; ++i) gait.Advance();
  const Pose2 before = gait.odometry();
  for (int i = 0; i < 210; ++i) gait.Advance();
  EXPECT_NEAR(gait.odometry().heading_rad - before.heading_rad, 0.35 / 2, 1e-9);
  EXPECT_NEAR(std::hypot(gait.odometry().x_m - before.x_m, gait.odometry().y_m - before.y_m), 0.01,
              2e-4);
}

TEST(PlanarGait, StopsWithinThreeStepsFromAnySpeed) {
  for (int begun = 1; begun < 700; begun += 37) {
    PlanarGait gait(WithoutSlip(), 1, kTick);
    gait.Move({0.09, 0, 0.1});
    for (int i = 0; i < begun; ++i) gait.Advance();
    gait.Move({});
    EXPECT_LE(Walk(gait), 3 * 0.42 + 2 * kTick_s);
  }
}

TEST(PlanarGait, CarryingFeetStandStillAndSwingingFeetLiftOff) {
  PlanarGait gait(NaoGaitConfig(), 7, kTick);
  gait.Move({0.07, 0.02, 0.1});
  double highest = 0;
  for (int i = 0; i < 4000; ++i) {
    const Eye carrying = gait.stance();
    const hardware::Pose before = gait.X_WF(carrying);
    gait.Advance();
    if (gait.phase() > 0) {
      ASSERT_TRUE(gait.X_WF(gait.stance()).isApprox(before, 1e-12) || carrying != gait.stance());
      const Eye swinging = gait.stance() == Eye::kLeft ? Eye::kRight : Eye::kLeft;
      highest = std::max(highest, gait.X_WF(swinging).translation().z());
    }
    EXPECT_EQ(gait.X_WF(gait.stance()).translation().z(), 0);
  }
  EXPECT_NEAR(highest, 0.02, 1e-4);
}

TEST(PlanarGait, FeetKeepTheDistanceThatTheRobotsClipDemands) {
  for (const hardware::WalkVelocity& v :
       {hardware::WalkVelocity{0, 1, 0}, hardware::WalkVelocity{0, -1, 0},
        hardware::WalkVelocity{0, 0, 1}, hardware::WalkVelocity{0.05, 0, -0.3}}) {
    PlanarGait gait(WithoutSlip(), 1, kTick);
    gait.Move(v);
    for (int i = 0; i < 3000; ++i) {
      gait.Advance();
      if (gait.phase() > 0) continue;
      const hardware::Pose X_LR = gait.X_WF(Eye::kLeft).inverse() * gait.X_WF(Eye::kRight);
      EXPECT_LE(-X_LR.translation().y(), 0.16 + 1e-6);
      EXPECT_GE(-X_LR.translation().y(), 0.088);
      EXPECT_LE(hardware::ToPose2(X_LR).heading_rad, 1e-6) << "toes turn inwards";
    }
  }
}

TEST(PlanarGait, SwaysTowardsTheFootThatCarriesOnceInTwoSteps) {
  PlanarGait gait(WithoutSlip(), 1, kTick);
  gait.Move({0.05, 0, 0});
  for (int i = 0; i < 2 * 210; ++i) gait.Advance();
  double leftmost = 0, rightmost = 0;
  for (int i = 0; i < 2 * 210; ++i) {
    gait.Advance();
    const double y = gait.X_WB().translation().y();
    leftmost = std::max(leftmost, y);
    rightmost = std::min(rightmost, y);
    if (gait.phase() > 0) {
      EXPECT_EQ(y > 0, gait.stance() == Eye::kLeft);
    }
  }
  EXPECT_NEAR(leftmost, 0.018, 1e-9);
  EXPECT_NEAR(rightmost, -0.018, 1e-9);
}

TEST(PlanarGait, BodyMovesWithoutJumps) {
  PlanarGait gait(NaoGaitConfig(), 3, kTick);
  gait.MoveTo({0.3, 0.1, 0.5});
  hardware::Pose before = gait.X_WB();
  while (gait.walking()) {
    gait.Advance();
    const hardware::Pose now = gait.X_WB();
    EXPECT_LT((now.translation() - before.translation()).norm(), 0.3 * kTick_s);
    before = now;
  }
}

TEST(PlanarGait, RecoilsTheWayItCameAndForgetsItsTarget) {
  PlanarGait gait(WithoutSlip(), 1, kTick);
  gait.MoveTo({1, 0, 0});
  for (int i = 0; i < 1000; ++i) gait.Advance();
  const Pose2 hit = gait.odometry();
  gait.Recoil();
  for (int i = 0; i < 100; ++i) {
    gait.Advance();
    gait.Recoil();
  }
  Walk(gait);
  ExpectPose(gait.odometry(), {hit.x_m - 0.04, 0, 0}, 1e-6, 1e-6);
  EXPECT_TRUE(gait.X_WB().isApprox(hardware::ToPose(gait.odometry()), 1e-6));
}

TEST(PlanarGait, SlipIsSmallSeededAndUnknownToTheOdometry) {
  std::set<double> ends;
  for (const std::uint64_t seed : {1, 2, 3, 4, 5, 6}) {
    PlanarGait gait(NaoGaitConfig(), seed, kTick), again(NaoGaitConfig(), seed, kTick);
    for (PlanarGait* g : {&gait, &again}) {
      g->MoveTo({1, 0, 0});
      Walk(*g);
    }
    ExpectPose(gait.odometry(), {1, 0, 0}, 1e-6, 1e-6);
    const Eigen::Vector3d end = gait.X_WB().translation();
    EXPECT_EQ(end, again.X_WB().translation());
    EXPECT_LT((end - Eigen::Vector3d(1, 0, 0)).norm(), 0.12);
    EXPECT_GT((end - Eigen::Vector3d(1, 0, 0)).norm(), 1e-4);
    ends.insert(end.x());
  }
  EXPECT_EQ(ends.size(), 6U);
}

TEST(PlanarGait, AStandingRobotIsWhereItWasPutAndTargetsItsOwnPoseWithoutAStep) {
  PlanarGait gait(WithoutSlip(), 1, kTick);
  gait.StandAt({1, 2, 0.5});
  gait.MoveTo({0, 0, 0});
  gait.Advance();
  EXPECT_FALSE(gait.walking());
  gait.MoveTo({0.1, 0, 0});
  Walk(gait);
  ExpectPose(hardware::ToPose2(gait.X_WB()),
             {1 + 0.1 * std::cos(0.5), 2 + 0.1 * std::sin(0.5), 0.5}, 1e-6, 1e-6);
  ExpectPose(gait.odometry(), {0.1, 0, 0}, 1e-6, 1e-6);
}

TEST(PlanarGait, BadConfigurationsNameEveryField) {
  NaoGaitConfig config;
  config.step_period_s = 0;
  config.slip_gain = -1;
  try {
    PlanarGait gait(config, 1, kTick);
    FAIL() << "expected ConfigError";
  } catch (const hardware::ConfigError& error) {
    EXPECT_EQ(error.errors().size(), 2U);
  }
}

}  // namespace
}  // namespace horopter::sim
