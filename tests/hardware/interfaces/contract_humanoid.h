// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "hardware/interfaces/clock.h"
#include "hardware/interfaces/humanoid.h"

namespace horopter::hardware {

/// The contract of `Humanoid`, over implementations. Instantiate DeviceContract beside it.
///
/// `Traits` is default-constructible, makes a fresh robot that stands with a metre of free floor
/// around it, and has
/// - `Humanoid& device()`, `Clock& clock()`;
/// - `Duration settle_time()`: enough to reach any walking velocity from any other;
/// - `double velocity_tolerance()`: of a settled velocity, relative to the greatest.
template <typename Traits>
class HumanoidContract : public testing::Test {
 protected:
  static constexpr Duration kLook = std::chrono::milliseconds(500);

  Humanoid& robot() { return traits_.device(); }
  Clock& clock() { return traits_.clock(); }

  void SetUpActive() {
    ASSERT_TRUE(robot().Configure().ok());
    ASSERT_TRUE(robot().Activate().ok());
  }

  void Pass(Duration d) { clock().SleepUntil(clock().Now() + d); }

  HumanoidState Read() {
    const auto state = robot().Read();
    EXPECT_TRUE(state.ok()) << (state.ok() ? "" : state.error().message);
    return state.ok() ? *state : HumanoidState{};
  }

  void Move(const WalkVelocity& velocity) {
    const auto commanded = robot().Move(velocity);
    ASSERT_TRUE(commanded.ok()) << commanded.error().message;
  }
  void MoveTo(const Pose2& target) {
    const auto commanded = robot().MoveTo(target);
    ASSERT_TRUE(commanded.ok()) << commanded.error().message;
  }

  /// Waits until the robot stands, at most as long as its slowest component needs for a metre.
  void WaitUntilItStands() {
    const Time latest = clock().Now() + FromSeconds(40);
    while (Read().walking) {
      ASSERT_LT(clock().Now(), latest) << "it never arrives";
      Pass(FromSeconds(0.05));
    }
  }

  static Pose2 Between(const Pose2& from, const Pose2& to) {
    return ToPose2(ToPose(from).inverse() * ToPose(to));
  }

  /// Velocity by the odometry once it has settled; curved paths are looked at for a short time.
  WalkVelocity Settled(const WalkVelocity& command) {
    Move(command);
    Pass(traits_.settle_time());
    const HumanoidState before = Read();
    Pass(FromSeconds(0.1));
    const HumanoidState after = Read();
    const Pose2 way = Between(before.odometry, after.odometry);
    const double dt = ToSeconds(std::max(after.t - before.t, Duration(1)));
    return {way.x_m / dt, way.y_m / dt, way.heading_rad / dt};
  }

  void ExpectVelocity(const WalkVelocity& got, const WalkVelocity& wanted) {
    const WalkVelocity most = robot().properties().max_velocity;
    const double tolerance = traits_.velocity_tolerance();
    EXPECT_NEAR(got.forward_m_s, wanted.forward_m_s, tolerance * most.forward_m_s);
    EXPECT_NEAR(got.left_m_s, wanted.left_m_s, tolerance * most.left_m_s);
    EXPECT_NEAR(got.turn_rad_s, wanted.turn_rad_s, tolerance * most.turn_rad_s);
  }

  void ExpectStandsStill(const std::string& when) {
    const HumanoidState before = Read();
    EXPECT_FALSE(before.walking) << when;
    Pass(kLook);
    const HumanoidState after = Read();
    EXPECT_FALSE(after.walking) << when;
    const Pose2 way = Between(before.odometry, after.odometry);
    EXPECT_LT(std::hypot(way.x_m, way.y_m), 1e-3) << when;
    EXPECT_LT(std::abs(way.heading_rad), 1e-3) << when;
  }

  void ExpectArrivedAt(const Pose2& start, const Pose2& target) {
    const Pose2 way = Between(start, Read().odometry);
    EXPECT_NEAR(way.x_m, target.x_m, 1e-3);
    EXPECT_NEAR(way.y_m, target.y_m, 1e-3);
    EXPECT_NEAR(WrapAngle(way.heading_rad - target.heading_rad), 0, 1e-3);
  }

  Traits traits_;
};
TYPED_TEST_SUITE_P(HumanoidContract);

TYPED_TEST_P(HumanoidContract, PropertiesMakeSense) {
  const HumanoidProperties properties = this->robot().properties();
  std::set<std::string> names;
  for (const HumanoidJoint& joint : properties.joints) {
    EXPECT_TRUE(names.insert(joint.name).second) << joint.name << " twice";
    EXPECT_LT(joint.min_rad, joint.max_rad) << joint.name;
    EXPECT_GT(joint.max_speed_rad_s, 0) << joint.name;
  }
  EXPECT_FALSE(names.empty());
  EXPECT_GT(properties.max_velocity.forward_m_s, 0);
  EXPECT_GT(properties.max_velocity.turn_rad_s, 0);
  EXPECT_GE(properties.max_velocity.left_m_s, 0);
  EXPECT_GT(properties.max_stop_time, Duration(0));
}

TYPED_TEST_P(HumanoidContract, ReadsEveryJointWhenInactiveAndActiveOnly) {
  const auto refused = this->robot().Read();
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, ErrorCode::kNotActive);
  ASSERT_TRUE(this->robot().Configure().ok());
  EXPECT_TRUE(this->robot().Read().ok());
  ASSERT_TRUE(this->robot().Activate().ok());
  const HumanoidState state = this->Read();
  const HumanoidProperties properties = this->robot().properties();
  ASSERT_EQ(state.joint_position.size(), properties.joints.size());
  for (std::size_t i = 0; i < properties.joints.size(); ++i) {
    EXPECT_GE(state.joint_position[i], properties.joints[i].min_rad - 0.01)
        << properties.joints[i].name;
    EXPECT_LE(state.joint_position[i], properties.joints[i].max_rad + 0.01)
        << properties.joints[i].name;
  }
}

TYPED_TEST_P(HumanoidContract, OdometryIsZeroAtTheFirstConfigureAndOnlyThere) {
  this->Pass(FromSeconds(0.1));
  ASSERT_TRUE(this->robot().Configure().ok());
  EXPECT_EQ(this->Read().odometry.x_m, 0);
  EXPECT_EQ(this->Read().odometry.heading_rad, 0);
  ASSERT_TRUE(this->robot().Activate().ok());
  this->MoveTo({0.1, 0, 0});
  this->WaitUntilItStands();
  this->robot().Deactivate();
  ASSERT_TRUE(this->robot().Configure().ok());
  EXPECT_NEAR(this->Read().odometry.x_m, 0.1, 1e-3);
}

TYPED_TEST_P(HumanoidContract, TimesOfStatesDoNotDecreaseAndAreNotInTheFuture) {
  this->SetUpActive();
  Time last{};
  for (int i = 0; i < 20; ++i) {
    const HumanoidState state = this->Read();
    EXPECT_GE(state.t, last);
    EXPECT_LE(state.t, this->clock().Now());
    last = state.t;
    this->Pass(FromSeconds(i % 3 * 0.004));
  }
  EXPECT_GT(last, Time{});
}

TYPED_TEST_P(HumanoidContract, WalksAtTheCommandedVelocity) {
  this->SetUpActive();
  const WalkVelocity most = this->robot().properties().max_velocity;
  for (const WalkVelocity& command :
       {WalkVelocity{most.forward_m_s / 2, 0, 0}, WalkVelocity{-most.forward_m_s / 2, 0, 0},
        WalkVelocity{0, most.left_m_s / 2, 0}, WalkVelocity{0, 0, -most.turn_rad_s / 2},
        WalkVelocity{most.forward_m_s / 3, 0, most.turn_rad_s / 3}}) {
    this->ExpectVelocity(this->Settled(command), command);
    EXPECT_TRUE(this->Read().walking);
  }
}

TYPED_TEST_P(HumanoidContract, TooFastIsScaledDownInAllComponentsTogether) {
  this->SetUpActive();
  const WalkVelocity most = this->robot().properties().max_velocity;
  this->ExpectVelocity(this->Settled({4 * most.forward_m_s, 0, 2 * most.turn_rad_s}),
                       {most.forward_m_s, 0, most.turn_rad_s / 2});
  this->ExpectVelocity(this->Settled({-most.forward_m_s, 0, 5 * most.turn_rad_s}),
                       {-most.forward_m_s / 5, 0, most.turn_rad_s});
}

TYPED_TEST_P(HumanoidContract, CommandsReturnAtOnce) {
  this->SetUpActive();
  const Time before = this->clock().Now();
  this->Move({0.01, 0, 0});
  this->MoveTo({0.1, 0, 0});
  ASSERT_TRUE(this->robot().Stop().ok());
  if constexpr (requires { TypeParam::kLockstep; }) {
    EXPECT_EQ(this->clock().Now(), before);
  } else {
    EXPECT_LT(this->clock().Now(), before + this->traits_.settle_time());
  }
}

TYPED_TEST_P(HumanoidContract, MoveToEndsStandingAtItsTarget) {
  this->SetUpActive();
  for (const Pose2& target :
       {Pose2{0.12, 0, 0}, Pose2{0, 0, 0.8}, Pose2{-0.05, 0, -0.3}, Pose2{0.08, 0.04, 0.5}}) {
    const Pose2 start = this->Read().odometry;
    this->MoveTo(target);
    EXPECT_TRUE(this->Read().walking);
    this->WaitUntilItStands();
    this->ExpectArrivedAt(start, target);
    this->ExpectStandsStill("after arrival");
  }
}

TYPED_TEST_P(HumanoidContract, ANewCommandReplacesTheOldOne) {
  this->SetUpActive();
  this->MoveTo({0.8, 0, 0});
  this->Pass(this->traits_.settle_time());
  const Pose2 on_its_way = this->Read().odometry;
  this->MoveTo({0.05, 0, 0.4});
  this->WaitUntilItStands();
  this->ExpectArrivedAt(on_its_way, {0.05, 0, 0.4});
  this->MoveTo({0.8, 0, 0});
  const WalkVelocity turn{0, 0, this->robot().properties().max_velocity.turn_rad_s / 2};
  this->ExpectVelocity(this->Settled(turn), turn);
}

TYPED_TEST_P(HumanoidContract, StopsWithinItsStopTimeAndStandsStill) {
  this->SetUpActive();
  const HumanoidProperties properties = this->robot().properties();
  for (const int halt : {0, 1, 2}) {
    this->Move({properties.max_velocity.forward_m_s, 0, 0});
    this->Pass(this->traits_.settle_time() + FromSeconds(0.13 * halt));
    if (halt == 2) {
      this->Move({});
    } else {
      ASSERT_TRUE(this->robot().Stop().ok());
    }
    this->Pass(properties.max_stop_time);
    this->ExpectStandsStill("after the stop time");
    EXPECT_TRUE(this->robot().Stop().ok()) << "stopping a standing robot";
  }
  this->ExpectStandsStill("after a second stop");
}

TYPED_TEST_P(HumanoidContract, HasNoDeadman) {
  this->SetUpActive();
  const WalkVelocity turn{0, 0, this->robot().properties().max_velocity.turn_rad_s / 2};
  this->Move(turn);
  this->Pass(FromSeconds(5));
  const Pose2 before = this->Read().odometry;
  this->Pass(FromSeconds(0.2));
  EXPECT_GT(this->Between(before, this->Read().odometry).heading_rad, 0.18 * turn.turn_rad_s);
  EXPECT_TRUE(this->Read().walking);
}

TYPED_TEST_P(HumanoidContract, CommandsThatAreNotFiniteAreRefusedWhole) {
  this->SetUpActive();
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    for (int component = 0; component < 3; ++component) {
      double v[3] = {0.05, 0, 0};
      v[component] = bad;
      const auto velocity = this->robot().Move({v[0], v[1], v[2]});
      ASSERT_FALSE(velocity.ok());
      EXPECT_EQ(velocity.error().code, ErrorCode::kOutOfRange);
      const auto target = this->robot().MoveTo({v[0], v[1], v[2]});
      ASSERT_FALSE(target.ok());
      EXPECT_EQ(target.error().code, ErrorCode::kOutOfRange);
    }
  }
  this->ExpectStandsStill("after refused commands");
  EXPECT_EQ(this->robot().lifecycle(), Lifecycle::kActive);
}

TYPED_TEST_P(HumanoidContract, CommandsAreRefusedUnlessActiveAndThenHaveNoEffect) {
  const auto expect_refused = [this](const Result<void>& refused, const std::string& what) {
    ASSERT_FALSE(refused.ok()) << what;
    EXPECT_EQ(refused.error().code, ErrorCode::kNotActive) << what;
  };
  const auto expect_all_refused = [&](const std::string& when) {
    expect_refused(this->robot().Move({0.05, 0, 0}), "Move while " + when);
    expect_refused(this->robot().MoveTo({0.3, 0, 0}), "MoveTo while " + when);
    expect_refused(this->robot().Stop(), "Stop while " + when);
  };
  expect_all_refused("unconfigured");
  ASSERT_TRUE(this->robot().Configure().ok());
  expect_all_refused("inactive");
  expect_refused(this->robot().Move({std::numeric_limits<double>::quiet_NaN(), 0, 0}),
                 "Move while inactive, and not finite");
  this->ExpectStandsStill("while inactive");
  ASSERT_TRUE(this->robot().Activate().ok());
  this->ExpectStandsStill("after activation without a command");
}

TYPED_TEST_P(HumanoidContract, DeactivationStopsItAsAStopDoes) {
  this->SetUpActive();
  for (const bool to_target : {false, true}) {
    ASSERT_TRUE(this->robot().Activate().ok());
    if (to_target) {
      this->MoveTo({0.5, 0, 0});
    } else {
      this->Move({0, 0, this->robot().properties().max_velocity.turn_rad_s});
    }
    this->Pass(this->traits_.settle_time());
    this->robot().Deactivate();
    this->Pass(this->robot().properties().max_stop_time);
    this->ExpectStandsStill("after deactivation");
  }
}

REGISTER_TYPED_TEST_SUITE_P(
    HumanoidContract, PropertiesMakeSense, ReadsEveryJointWhenInactiveAndActiveOnly,
    OdometryIsZeroAtTheFirstConfigureAndOnlyThere, TimesOfStatesDoNotDecreaseAndAreNotInTheFuture,
    WalksAtTheCommandedVelocity, TooFastIsScaledDownInAllComponentsTogether, CommandsReturnAtOnce,
    MoveToEndsStandingAtItsTarget, ANewCommandReplacesTheOldOne,
    StopsWithinItsStopTimeAndStandsStill, HasNoDeadman, CommandsThatAreNotFiniteAreRefusedWhole,
    CommandsAreRefusedUnlessActiveAndThenHaveNoEffect, DeactivationStopsItAsAStopDoes);

}  // namespace horopter::hardware
