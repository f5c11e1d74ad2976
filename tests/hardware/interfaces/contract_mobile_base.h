// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "hardware/interfaces/clock.h"
#include "hardware/interfaces/mobile_base.h"

namespace horopter::hardware {

/// The contract of `MobileBase`, over implementations. Instantiate DeviceContract beside it.
///
/// `Traits` is default-constructible, makes a fresh base at rest with two metres of free floor
/// around it, and has
/// - `MobileBase& device()`, `Clock& clock()`;
/// - `Duration deadman()`: after this long without a command the base stops by itself;
/// - `Duration settle_time()`: enough to reach any speed and to stop from it;
/// - `double speed_tolerance()`: of a settled speed, relative to the commanded one.
template <typename Traits>
class MobileBaseContract : public testing::Test {
 protected:
  static constexpr double kStill_m = 1e-3;  ///< less than this in kLook counts as at rest
  static constexpr Duration kLook = std::chrono::milliseconds(300);

  MobileBase& base() { return traits_.device(); }
  Clock& clock() { return traits_.clock(); }

  void SetUpActive() {
    ASSERT_TRUE(base().Configure().ok());
    ASSERT_TRUE(base().Activate().ok());
  }

  void Pass(Duration d) { clock().SleepUntil(clock().Now() + d); }

  BaseState Read() {
    const auto state = base().Read();
    EXPECT_TRUE(state.ok()) << (state.ok() ? "" : state.error().message);
    return state.ok() ? *state : BaseState{};
  }

  /// Repeats a command often enough to keep the deadman content.
  void Drive(const WheelSpeeds& speeds, Duration d) {
    const Time end = clock().Now() + d;
    while (clock().Now() < end) {
      const auto commanded = base().Command(speeds);
      ASSERT_TRUE(commanded.ok()) << commanded.error().message;
      clock().SleepUntil(std::min(end, clock().Now() + traits_.deadman() / 3));
    }
  }

  WheelSpeeds Between(const BaseState& before, const BaseState& after) {
    const double scale =
        base().properties().metres_per_pulse / ToSeconds(std::max(after.t - before.t, Duration(1)));
    return {static_cast<double>(after.left_pulses - before.left_pulses) * scale,
            static_cast<double>(after.right_pulses - before.right_pulses) * scale};
  }

  /// Speeds by the encoders once they have settled under a command.
  WheelSpeeds SettledSpeeds(const WheelSpeeds& command) {
    Drive(command, traits_.settle_time());
    const BaseState before = Read();
    Drive(command, kLook);
    return Between(before, Read());
  }

  void ExpectStill(const char* when) {
    const BaseState before = Read();
    Pass(kLook);
    const BaseState after = Read();
    const double metres_per_pulse = base().properties().metres_per_pulse;
    EXPECT_LT(std::abs(after.left_pulses - before.left_pulses) * metres_per_pulse, kStill_m)
        << when;
    EXPECT_LT(std::abs(after.right_pulses - before.right_pulses) * metres_per_pulse, kStill_m)
        << when;
  }

  Traits traits_;
};
TYPED_TEST_SUITE_P(MobileBaseContract);

TYPED_TEST_P(MobileBaseContract, PropertiesArePositiveAndFinite) {
  const BaseProperties properties = this->base().properties();
  for (const double value : {properties.metres_per_pulse, properties.effective_track_m,
                             properties.max_wheel_speed_m_s}) {
    EXPECT_GT(value, 0);
    EXPECT_TRUE(std::isfinite(value));
  }
}

TYPED_TEST_P(MobileBaseContract, ReadsWhenInactiveAndActiveOnly) {
  const auto refused = this->base().Read();
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, ErrorCode::kNotActive);
  ASSERT_TRUE(this->base().Configure().ok());
  EXPECT_TRUE(this->base().Read().ok());
  ASSERT_TRUE(this->base().Activate().ok());
  EXPECT_TRUE(this->base().Read().ok());
}

TYPED_TEST_P(MobileBaseContract, EncodersAreZeroAtTheFirstConfigureAndOnlyThere) {
  this->Pass(FromSeconds(0.1));
  ASSERT_TRUE(this->base().Configure().ok());
  const BaseState first = this->Read();
  EXPECT_EQ(first.left_pulses, 0);
  EXPECT_EQ(first.right_pulses, 0);
  ASSERT_TRUE(this->base().Activate().ok());
  const double speed = this->base().properties().max_wheel_speed_m_s / 3;
  this->Drive({speed, speed}, this->traits_.settle_time() + this->kLook);
  this->base().Deactivate();
  this->Pass(this->traits_.settle_time());
  const BaseState driven = this->Read();
  EXPECT_GT(driven.left_pulses * this->base().properties().metres_per_pulse, 0.01);
  ASSERT_TRUE(this->base().Configure().ok());
  const BaseState again = this->Read();
  EXPECT_NEAR(again.left_pulses, driven.left_pulses, 2);
  EXPECT_NEAR(again.right_pulses, driven.right_pulses, 2);
}

TYPED_TEST_P(MobileBaseContract, TimesOfStatesDoNotDecreaseAndAreNotInTheFuture) {
  this->SetUpActive();
  Time last{};
  for (int i = 0; i < 20; ++i) {
    const BaseState state = this->Read();
    EXPECT_GE(state.t, last);
    EXPECT_LE(state.t, this->clock().Now());
    last = state.t;
    this->Pass(FromSeconds(i % 3 * 0.004));
  }
  EXPECT_GT(last, Time{});
}

TYPED_TEST_P(MobileBaseContract, WheelsTakeTheCommandedSpeeds) {
  this->SetUpActive();
  const double speed = this->base().properties().max_wheel_speed_m_s / 4;
  const double tolerance = speed * this->traits_.speed_tolerance();
  for (const WheelSpeeds& command :
       {WheelSpeeds{speed, speed}, WheelSpeeds{-speed, -speed}, WheelSpeeds{-speed, speed}}) {
    const WheelSpeeds measured = this->SettledSpeeds(command);
    EXPECT_NEAR(measured.left_m_s, command.left_m_s, tolerance);
    EXPECT_NEAR(measured.right_m_s, command.right_m_s, tolerance);
  }
}

TYPED_TEST_P(MobileBaseContract, CommandReturnsAtOnce) {
  this->SetUpActive();
  const Time before = this->clock().Now();
  ASSERT_TRUE(this->base().Command({0.1, 0.1}).ok());
  if constexpr (requires { TypeParam::kLockstep; }) {
    EXPECT_EQ(this->clock().Now(), before);
  } else {
    EXPECT_LT(this->clock().Now(), before + this->traits_.settle_time());
  }
}

TYPED_TEST_P(MobileBaseContract, TooFastIsScaledDownTogetherSoThatTheCurveStays) {
  this->SetUpActive();
  const double most = this->base().properties().max_wheel_speed_m_s;
  const double tolerance = most * this->traits_.speed_tolerance();
  const WheelSpeeds forward = this->SettledSpeeds({1.2 * most, 2.4 * most});
  EXPECT_NEAR(forward.left_m_s, most / 2, tolerance);
  EXPECT_NEAR(forward.right_m_s, most, tolerance);
  const WheelSpeeds backward = this->SettledSpeeds({-4 * most, -3 * most});
  EXPECT_NEAR(backward.left_m_s, -most, tolerance);
  EXPECT_NEAR(backward.right_m_s, -most * 3 / 4, tolerance);
}

TYPED_TEST_P(MobileBaseContract, ASpeedThatIsNotFiniteIsRefusedAndHasNoEffect) {
  this->SetUpActive();
  const double speed = this->base().properties().max_wheel_speed_m_s / 2;
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
        -std::numeric_limits<double>::infinity()}) {
    for (const WheelSpeeds& command : {WheelSpeeds{bad, speed}, WheelSpeeds{speed, bad}}) {
      const auto refused = this->base().Command(command);
      ASSERT_FALSE(refused.ok());
      EXPECT_EQ(refused.error().code, ErrorCode::kOutOfRange);
    }
  }
  this->ExpectStill("after refused commands");
  EXPECT_EQ(this->base().lifecycle(), Lifecycle::kActive);
}

TYPED_TEST_P(MobileBaseContract, CommandsAreRefusedUnlessActiveAndThenHaveNoEffect) {
  const double speed = this->base().properties().max_wheel_speed_m_s / 2;
  const auto expect_refused = [this](const WheelSpeeds& command, const char* when) {
    const auto refused = this->base().Command(command);
    ASSERT_FALSE(refused.ok()) << when;
    EXPECT_EQ(refused.error().code, ErrorCode::kNotActive) << when;
  };
  expect_refused({speed, speed}, "unconfigured");
  ASSERT_TRUE(this->base().Configure().ok());
  expect_refused({speed, speed}, "inactive");
  expect_refused({std::numeric_limits<double>::quiet_NaN(), speed}, "inactive, and not finite");
  this->ExpectStill("while inactive");
  ASSERT_TRUE(this->base().Activate().ok());
  this->ExpectStill("after activation without a command");
}

TYPED_TEST_P(MobileBaseContract, RunsOnUntilTheDeadmanAndThenStopsByItself) {
  this->SetUpActive();
  const double speed = this->base().properties().max_wheel_speed_m_s / 4;
  this->Drive({speed, speed}, this->traits_.settle_time());
  ASSERT_TRUE(this->base().Command({speed, speed}).ok());
  const BaseState before = this->Read();
  this->Pass(this->traits_.deadman() * 3 / 4);
  const WheelSpeeds on_its_way = this->Between(before, this->Read());
  EXPECT_NEAR(on_its_way.left_m_s, speed, speed * this->traits_.speed_tolerance());
  this->Pass(this->traits_.deadman() / 4 + this->traits_.settle_time());
  this->ExpectStill("after the deadman's time and the way to a stop");
  EXPECT_EQ(this->base().lifecycle(), Lifecycle::kActive);
  const WheelSpeeds resumed = this->SettledSpeeds({speed, speed});
  EXPECT_NEAR(resumed.left_m_s, speed, speed * this->traits_.speed_tolerance());
}

TYPED_TEST_P(MobileBaseContract, DeactivationStopsItAsFastAsACommandToStop) {
  this->SetUpActive();
  const double speed = this->base().properties().max_wheel_speed_m_s / 4;
  const auto way_to_rest = [&](auto stop) {
    this->Drive({speed, speed}, this->traits_.settle_time());
    const BaseState before = this->Read();
    stop();
    this->Pass(this->traits_.settle_time());
    this->ExpectStill("once stopped");
    return (this->Read().left_pulses - before.left_pulses) *
           this->base().properties().metres_per_pulse;
  };
  const double commanded = way_to_rest([this] { ASSERT_TRUE(this->base().Command({0, 0}).ok()); });
  const double deactivated = way_to_rest([this] { this->base().Deactivate(); });
  EXPECT_LT(deactivated, 1.2 * commanded + 2 * this->kStill_m);
}

REGISTER_TYPED_TEST_SUITE_P(
    MobileBaseContract, PropertiesArePositiveAndFinite, ReadsWhenInactiveAndActiveOnly,
    EncodersAreZeroAtTheFirstConfigureAndOnlyThere, TimesOfStatesDoNotDecreaseAndAreNotInTheFuture,
    WheelsTakeTheCommandedSpeeds, CommandReturnsAtOnce,
    TooFastIsScaledDownTogetherSoThatTheCurveStays, ASpeedThatIsNotFiniteIsRefusedAndHasNoEffect,
    CommandsAreRefusedUnlessActiveAndThenHaveNoEffect, RunsOnUntilTheDeadmanAndThenStopsByItself,
    DeactivationStopsItAsFastAsACommandToStop);

}  // namespace horopter::hardware
