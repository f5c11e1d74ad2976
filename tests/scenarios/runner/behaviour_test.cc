// SPDX-License-Identifier: Apache-2.0
#include "scenarios/runner/behaviour.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "control/kinematics/head_kinematics.h"

namespace horopter::scenarios {
namespace {

using hardware::FromSeconds;
using hardware::HeadAngles;

constexpr double kRadians = M_PI / 180;

class BehaviourTest : public testing::Test {
 protected:
  BehaviourTest() {
    context_.geometry.baseline_m = 0.08;
    context_.geometry.X_BN.translation() << 0.05, 0, 0.3;
    for (int axis = 2; axis < hardware::kHeadAxisCount; ++axis) {
      context_.limits[axis] = {-1.0, 1.0, 2, 10};
    }
    context_.settled_rad = 0.1 * kRadians;
  }

  /// Ticks every 20 ms with a head that follows at once after `lag_s`; @return ticks until done.
  int Play(Behaviour& behaviour, double lag_s, int most = 1000) {
    StackState state;
    for (int tick = 0; tick < most; ++tick) {
      state.t = hardware::Time(std::chrono::milliseconds(20 * tick));
      outputs_.push_back(behaviour.Update(state));
      if (outputs_.back().done) return tick;
      if (outputs_.back().head && ToSeconds(state.t) >= lag_s) state.angles = *outputs_.back().head;
    }
    return most;
  }

  BehaviourContext context_;
  control::Navigator navigator_{control::NavigatorConfig{}};
  std::vector<StepOutput> outputs_;
};

TEST_F(BehaviourTest, FixateTurnsBothAxesThroughTheTargetAndHolds) {
  const Eigen::Vector3d target(1.0, 0.2, 0.4);
  const auto fixate = MakeBehaviour(FixateStep{target, 0.5}, context_, navigator_);
  const int ticks = Play(*fixate, 0.2);
  EXPECT_NEAR(ticks * 0.02, 0.2 + 0.5, 0.05);
  const auto meeting = control::FindFixationPoint(context_.geometry, *outputs_.back().head);
  ASSERT_TRUE(meeting.has_value());
  EXPECT_LT((meeting->p_B - target).norm(), 1e-9);
}

TEST_F(BehaviourTest, FixationIsScoredOnlyOnceTheHeadHasArrived) {
  const auto fixate = MakeBehaviour(FixateStep{{1, 0, 0.3}, 0.5}, context_, navigator_);
  Play(*fixate, 0.2);
  EXPECT_FALSE(outputs_.front().fixated_O.has_value());
  EXPECT_TRUE(outputs_.back().fixated_O.has_value());
}

TEST_F(BehaviourTest, HeadThatNeverArrivesNeverEndsTheStep) {
  const auto fixate = MakeBehaviour(FixateStep{{1, 0.3, 0.3}, 0.1}, context_, navigator_);
  EXPECT_EQ(Play(*fixate, 1e9, 200), 200);
}

TEST_F(BehaviourTest, TargetBehindTheRobotFailsWithTheReason) {
  const auto fixate = MakeBehaviour(FixateStep{{-1, 0, 0.3}, 0.5}, context_, navigator_);
  EXPECT_EQ(Play(*fixate, 0), 0);
  EXPECT_THAT(outputs_.back().failure, testing::HasSubstr("cannot fixate"));
  EXPECT_TRUE(outputs_.back().impossible);
  EXPECT_FALSE(outputs_.back().fixated_O.has_value());  // a gaze never held is not scored
}

TEST_F(BehaviourTest, GazeThatIsLostIsNoLongerScored) {
  const auto fixate = MakeBehaviour(FixateStep{{1, 0, 0.3}, 5}, context_, navigator_);
  Play(*fixate, 0, 10);
  ASSERT_TRUE(outputs_.back().fixated_O.has_value());
  StackState state;
  state.X_OB = {2, 0, 0};  // the target is behind it now
  const StepOutput lost = fixate->Update(state);
  EXPECT_TRUE(lost.done);
  EXPECT_FALSE(lost.fixated_O.has_value());
}

TEST_F(BehaviourTest, LookAtKeepsTheAxesParallel) {
  const auto look = MakeBehaviour(LookAtStep{{1, 0.5, 0.3}, 0.1}, context_, navigator_);
  Play(*look, 0);
  const HeadAngles& angles = *outputs_.back().head;
  EXPECT_DOUBLE_EQ(angles.left.pan_rad, angles.right.pan_rad);
  EXPECT_NEAR(angles.left.pan_rad, std::atan2(0.5, 0.95), 0.01);
}

TEST_F(BehaviourTest, SaccadeVergesBothEyesAboutItsPan) {
  const auto saccade = MakeBehaviour(SaccadeStep{20, 5, 4, 0.1}, context_, navigator_);
  Play(*saccade, 0);
  const HeadAngles& angles = *outputs_.back().head;
  EXPECT_NEAR(angles.left.pan_rad, 18 * kRadians, 1e-12);
  EXPECT_NEAR(angles.right.pan_rad, 22 * kRadians, 1e-12);
  EXPECT_NEAR(angles.left.tilt_rad, 5 * kRadians, 1e-12);
  EXPECT_DOUBLE_EQ(angles.neck.pan_rad, 0);
}

TEST_F(BehaviourTest, WaitLastsItsDuration) {
  const auto wait = MakeBehaviour(WaitStep{0.4}, context_, navigator_);
  EXPECT_EQ(Play(*wait, 0), 20);
  EXPECT_EQ(outputs_.back().twist.forward_m_s, 0);
}

TEST_F(BehaviourTest, GotoWithoutAViewStandsStillUntilItsTimeout) {
  const auto go = MakeBehaviour(GotoStep{{2, 0}, 0.1, 3}, context_, navigator_);
  EXPECT_NEAR(Play(*go, 0) * 0.02, 3, 0.05);
  EXPECT_THAT(outputs_.back().failure, testing::HasSubstr("2.00 m left"));
  for (const StepOutput& output : outputs_) EXPECT_EQ(output.twist.forward_m_s, 0);
}

}  // namespace
}  // namespace horopter::scenarios
