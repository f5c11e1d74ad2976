// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <optional>

#include "hardware/interfaces/clock.h"

namespace horopter::hardware {

/// The contract of `Clock`, over implementations.
///
/// `Traits` is default-constructible, makes a fresh clock that the test's thread may sleep on, and
/// has
/// - `Clock& clock()`;
/// - `std::optional<Duration> step()`: in lockstep, what times are rounded up to (zero: nothing);
///   nothing for a clock that runs by itself.
template <typename Traits>
class ClockContract : public testing::Test {
 protected:
  Clock& clock() { return traits_.clock(); }
  Traits traits_;
};
TYPED_TEST_SUITE_P(ClockContract);

TYPED_TEST_P(ClockContract, StartsAtZeroOrJustAfter) {
  const Time now = this->clock().Now();
  if (this->traits_.step().has_value()) {
    EXPECT_EQ(now, Time{});
  } else {
    EXPECT_GE(now, Time{});
  }
}

TYPED_TEST_P(ClockContract, SleepsUntilTheTimeAndNotLess) {
  for (const double seconds : {0.001, 0.0035, 0.010, 0.0101}) {
    const Time target = Time(FromSeconds(seconds));
    this->clock().SleepUntil(target);
    ASSERT_GE(this->clock().Now(), target);
    if (const std::optional<Duration> step = this->traits_.step()) {
      const Duration t = target.time_since_epoch();
      const Duration rounded =
          step->count() == 0 ? t : (t + *step - Duration(1)) / step->count() * step->count();
      EXPECT_EQ(this->clock().Now(), Time(rounded));
    }
  }
}

TYPED_TEST_P(ClockContract, APassedTimeReturnsAtOnce) {
  this->clock().SleepUntil(Time(FromSeconds(0.010)));
  const Time before = this->clock().Now();
  this->clock().SleepUntil(before);
  this->clock().SleepUntil(Time(FromSeconds(0.004)));
  this->clock().SleepUntil(Time(FromSeconds(-1)));
  if (this->traits_.step().has_value()) {
    EXPECT_EQ(this->clock().Now(), before);
  }
}

TYPED_TEST_P(ClockContract, NeverDecreases) {
  Time last = this->clock().Now();
  for (int i = 0; i < 40; ++i) {
    this->clock().SleepUntil(Time(FromSeconds((i * 7 % 11) * 0.0007)));
    const Time now = this->clock().Now();
    ASSERT_GE(now, last);
    last = now;
  }
}

REGISTER_TYPED_TEST_SUITE_P(ClockContract, StartsAtZeroOrJustAfter, SleepsUntilTheTimeAndNotLess,
                            APassedTimeReturnsAtOnce, NeverDecreases);

}  // namespace horopter::hardware
