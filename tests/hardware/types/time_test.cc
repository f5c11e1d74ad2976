// SPDX-License-Identifier: Apache-2.0
#include "hardware/types/time.h"

#include <gtest/gtest.h>

namespace horopter::hardware {
namespace {

TEST(Time, SecondsRoundToTheNearestNanosecondOnBothSidesOfZero) {
  EXPECT_EQ(FromSeconds(0.002).count(), 2'000'000);
  EXPECT_EQ(FromSeconds(-0.002).count(), -2'000'000);
  EXPECT_EQ(FromSeconds(1.6e-9).count(), 2);
  EXPECT_EQ(FromSeconds(-1.6e-9).count(), -2);
  EXPECT_EQ(FromSeconds(1.4e-9).count(), 1);
  EXPECT_EQ(FromSeconds(0.0).count(), 0);
}

TEST(Time, EveryMicrosecondOfAnHourSurvivesTheRoundTrip) {
  for (std::int64_t us = 0; us < 3'600'000'000; us += 999'983) {
    const Duration d = std::chrono::microseconds(us);
    ASSERT_EQ(FromSeconds(ToSeconds(d)), d);
  }
}

TEST(Time, StepsAddUpWithoutDrift) {
  Time t{};
  for (int i = 0; i < 100'000; ++i) t += FromSeconds(0.002);
  EXPECT_EQ(t, Time(std::chrono::seconds(200)));
  EXPECT_DOUBLE_EQ(ToSeconds(t), 200.0);
}

}  // namespace
}  // namespace horopter::hardware
