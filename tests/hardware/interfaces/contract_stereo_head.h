// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "hardware/interfaces/clock.h"
#include "hardware/interfaces/stereo_head.h"

namespace horopter::hardware {

/// The contract of `StereoHead`, over implementations. Instantiate DeviceContract beside it.
///
/// `Traits` is default-constructible, makes a fresh head at rest, and has
/// - `StereoHead& device()`, `Clock& clock()`;
/// - `HeadAxisArray encoder_tolerance_rad()`: one encoder step, plus what noise may add;
/// - `Duration settle_time()`: enough for every axis to cross its range and come to rest;
/// - where an axis' range depends on another's angle: `HeadAngles Reachable(HeadAngles)`, what a
///   target within limits() is clamped to.
template <typename Traits>
class StereoHeadContract : public testing::Test {
 protected:
  StereoHead& head() { return traits_.device(); }
  Clock& clock() { return traits_.clock(); }

  void SetUpActive() {
    ASSERT_TRUE(head().Configure().ok());
    ASSERT_TRUE(head().Activate().ok());
  }

  void Pass(Duration d) { clock().SleepUntil(clock().Now() + d); }

  HeadReading Read() {
    const auto reading = head().Read();
    EXPECT_TRUE(reading.ok()) << (reading.ok() ? "" : reading.error().message);
    return reading.ok() ? *reading : HeadReading{};
  }

  /// The same fraction of every axis' range, as far as it is reachable; 0 is the lower limit, 1 the
  /// upper.
  HeadAngles Inside(double fraction) {
    HeadAxisArray angles{};
    const HeadLimits limits = head().limits();
    for (int i = 0; i < kHeadAxisCount; ++i) {
      angles[i] = limits[i].min_rad + fraction * (limits[i].max_rad - limits[i].min_rad);
    }
    if constexpr (requires { traits_.Reachable(FromArray(angles)); }) {
      return traits_.Reachable(FromArray(angles));
    }
    return FromArray(angles);
  }

  void GoTo(const HeadAngles& target) {
    const auto commanded = head().Command(target);
    ASSERT_TRUE(commanded.ok()) << commanded.error().message;
    Pass(traits_.settle_time());
  }

  /// @param steps how many encoder tolerances are forgiven
  void ExpectAt(const HeadAngles& expected, double steps, const std::string& when) {
    const HeadAxisArray angles = ToArray(Read().angles), wanted = ToArray(expected);
    const HeadAxisArray tolerance = traits_.encoder_tolerance_rad();
    for (int i = 0; i < kHeadAxisCount; ++i) {
      EXPECT_NEAR(angles[i], wanted[i], steps * tolerance[i] + 1e-12)
          << kHeadAxisNames[i] << " " << when;
    }
  }

  Traits traits_;
};
TYPED_TEST_SUITE_P(StereoHeadContract);

TYPED_TEST_P(StereoHeadContract, HasAnAxisAndLimitsThatMakeSense) {
  int axes = 0;
  for (const AxisLimits& axis : this->head().limits()) {
    EXPECT_LE(axis.min_rad, axis.max_rad);
    if (!axis.exists()) {
      EXPECT_EQ(axis.min_rad, 0);
      EXPECT_EQ(axis.max_rad, 0);
      continue;
    }
    ++axes;
    EXPECT_GT(axis.max_speed_rad_s, 0);
    EXPECT_GT(axis.max_acceleration_rad_s2, 0);
  }
  EXPECT_GE(axes, 1);
}

TYPED_TEST_P(StereoHeadContract, ReadsWhenInactiveAndActiveOnly) {
  const auto refused = this->head().Read();
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, ErrorCode::kNotActive);
  ASSERT_TRUE(this->head().Configure().ok());
  EXPECT_TRUE(this->head().Read().ok());
  ASSERT_TRUE(this->head().Activate().ok());
  EXPECT_TRUE(this->head().Read().ok());
}

TYPED_TEST_P(StereoHeadContract, TimesOfReadingsDoNotDecreaseAndAreNotInTheFuture) {
  this->SetUpActive();
  ASSERT_TRUE(this->head().Command(this->Inside(0.8)).ok());
  Time last{};
  for (int i = 0; i < 20; ++i) {
    const HeadReading reading = this->Read();
    EXPECT_GE(reading.t, last);
    EXPECT_LE(reading.t, this->clock().Now());
    last = reading.t;
    this->Pass(FromSeconds(i % 3 * 0.004));
  }
  EXPECT_GT(last, Time{});
}

TYPED_TEST_P(StereoHeadContract, CommandsAreRefusedUnlessActiveAndThenHaveNoEffect) {
  const auto refused_as_not_active = [this](const HeadAngles& target, const char* when) {
    const auto refused = this->head().Command(target);
    ASSERT_FALSE(refused.ok()) << when;
    EXPECT_EQ(refused.error().code, ErrorCode::kNotActive) << when;
  };
  refused_as_not_active(this->Inside(0.9), "unconfigured");
  this->SetUpActive();
  this->GoTo(this->Inside(0.4));
  this->head().Deactivate();
  this->Pass(this->traits_.settle_time());
  const HeadAngles before = this->Read().angles;
  refused_as_not_active(this->Inside(0.9), "inactive");
  HeadAngles nonsense = this->Inside(0.9);
  nonsense.left.pan_rad = std::numeric_limits<double>::quiet_NaN();
  refused_as_not_active(nonsense, "inactive, and not finite");
  this->Pass(this->traits_.settle_time());
  this->ExpectAt(before, 2, "after refused commands");
}

TYPED_TEST_P(StereoHeadContract, ReadingsSettleWithinAnEncoderStepOfTheTarget) {
  this->SetUpActive();
  for (const double fraction : {0.5, 0.1, 0.93, 0.37}) {
    this->GoTo(this->Inside(fraction));
    this->ExpectAt(this->Inside(fraction), 1, "at " + std::to_string(fraction));
    this->Pass(FromSeconds(0.1));
    this->ExpectAt(this->Inside(fraction), 1, "still at " + std::to_string(fraction));
  }
}

TYPED_TEST_P(StereoHeadContract, EveryAxisMovesByItself) {
  this->SetUpActive();
  const HeadLimits limits = this->head().limits();
  this->GoTo(this->Inside(0.5));
  for (int i = 0; i < kHeadAxisCount; ++i) {
    if (!limits[i].exists()) continue;
    HeadAxisArray target = ToArray(this->Inside(0.5));
    target[i] = ToArray(this->Inside(0.7))[i];
    this->GoTo(FromArray(target));
    this->ExpectAt(FromArray(target), 1, "when it alone is moved");
  }
}

TYPED_TEST_P(StereoHeadContract, CommandReturnsAtOnceAndTheAxesTakeTheTimeTheirLimitsNeed) {
  this->SetUpActive();
  this->GoTo(this->Inside(0.2));
  const HeadLimits limits = this->head().limits();
  const HeadAxisArray tolerance = this->traits_.encoder_tolerance_rad();
  const HeadAxisArray from = ToArray(this->Inside(0.2)), to = ToArray(this->Inside(0.8));
  const Time start = this->clock().Now();
  ASSERT_TRUE(this->head().Command(this->Inside(0.8)).ok());
  if constexpr (requires { TypeParam::kLockstep; }) {
    EXPECT_EQ(this->clock().Now(), start);
  }
  for (int k = 0; k < 40; ++k) {
    const HeadReading reading = this->Read();
    const double elapsed = ToSeconds(reading.t - start);
    for (int i = 0; i < kHeadAxisCount; ++i) {
      if (!limits[i].exists()) continue;
      const double reach = std::min(limits[i].max_speed_rad_s * elapsed,
                                    0.5 * limits[i].max_acceleration_rad_s2 * elapsed * elapsed);
      EXPECT_LE(std::abs(ToArray(reading.angles)[i] - from[i]), reach + 2 * tolerance[i])
          << kHeadAxisNames[i] << " after " << elapsed << " s";
    }
    this->Pass(FromSeconds(0.005));
  }
  this->Pass(this->traits_.settle_time());
  this->ExpectAt(FromArray(to), 1, "in the end");
}

TYPED_TEST_P(StereoHeadContract, TargetsBeyondTheLimitsAreClampedAndMissingAxesIgnored) {
  this->SetUpActive();
  for (const double side : {-1.0, 1.0}) {
    HeadAxisArray beyond{};
    beyond.fill(side * 50);
    this->GoTo(FromArray(beyond));
    this->ExpectAt(this->Inside(side < 0 ? 0 : 1), 1, "when commanded far beyond its limit");
  }
}

TYPED_TEST_P(StereoHeadContract, ATargetThatIsNotFiniteIsRefusedWhole) {
  this->SetUpActive();
  this->GoTo(this->Inside(0.4));
  for (int i = 0; i < kHeadAxisCount; ++i) {
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
      HeadAxisArray target = ToArray(this->Inside(0.9));
      target[i] = bad;
      const auto refused = this->head().Command(FromArray(target));
      ASSERT_FALSE(refused.ok()) << kHeadAxisNames[i] << " = " << bad;
      EXPECT_EQ(refused.error().code, ErrorCode::kOutOfRange);
    }
  }
  this->Pass(this->traits_.settle_time());
  this->ExpectAt(this->Inside(0.4), 1, "after refused commands");
  EXPECT_EQ(this->head().lifecycle(), Lifecycle::kActive);
}

TYPED_TEST_P(StereoHeadContract, ANewCommandReplacesTheOldOne) {
  this->SetUpActive();
  this->GoTo(this->Inside(0.3));
  ASSERT_TRUE(this->head().Command(this->Inside(0.9)).ok());
  this->Pass(FromSeconds(0.01));
  this->GoTo(this->Inside(0.2));
  this->ExpectAt(this->Inside(0.2), 1, "after a replaced command");
}

TYPED_TEST_P(StereoHeadContract, DeactivationStopsTheAxesWhereTheyAre) {
  this->SetUpActive();
  this->GoTo(this->Inside(0.1));
  ASSERT_TRUE(this->head().Command(this->Inside(0.9)).ok());
  this->Pass(FromSeconds(0.02));
  this->head().Deactivate();
  this->Pass(this->traits_.settle_time());
  const HeadReading stopped = this->Read();
  this->Pass(this->traits_.settle_time());
  this->ExpectAt(stopped.angles, 2, "long after it stopped");
  const HeadAxisArray goal = ToArray(this->Inside(0.9));
  const HeadLimits limits = this->head().limits();
  for (int i = 0; i < kHeadAxisCount; ++i) {
    if (!limits[i].exists()) continue;
    EXPECT_GT(std::abs(ToArray(stopped.angles)[i] - goal[i]),
              2 * this->traits_.encoder_tolerance_rad()[i])
        << kHeadAxisNames[i] << " went on to its target";
  }
}

REGISTER_TYPED_TEST_SUITE_P(StereoHeadContract, HasAnAxisAndLimitsThatMakeSense,
                            ReadsWhenInactiveAndActiveOnly,
                            TimesOfReadingsDoNotDecreaseAndAreNotInTheFuture,
                            CommandsAreRefusedUnlessActiveAndThenHaveNoEffect,
                            ReadingsSettleWithinAnEncoderStepOfTheTarget, EveryAxisMovesByItself,
                            CommandReturnsAtOnceAndTheAxesTakeTheTimeTheirLimitsNeed,
                            TargetsBeyondTheLimitsAreClampedAndMissingAxesIgnored,
                            ATargetThatIsNotFiniteIsRefusedWhole, ANewCommandReplacesTheOldOne,
                            DeactivationStopsTheAxesWhereTheyAre);

}  // namespace horopter::hardware
