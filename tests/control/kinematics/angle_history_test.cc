// SPDX-License-Identifier: Apache-2.0
#include "control/kinematics/angle_history.h"

#include <gtest/gtest.h>

namespace horopter::control {
namespace {

using hardware::FromSeconds;
using hardware::Time;

hardware::HeadReading Reading(double t_s, double pan_rad) {
  hardware::HeadReading reading;
  reading.t = Time(FromSeconds(t_s));
  reading.angles.left.pan_rad = pan_rad;
  return reading;
}

TEST(AngleHistory, InterpolatesAndHoldsAtItsEnds) {
  AngleHistory history;
  EXPECT_EQ(history.At(Time{}).left.pan_rad, 0);
  history.Add(Reading(1.0, 0.2));
  history.Add(Reading(1.1, 0.4));
  history.Add(Reading(1.05, 9));  // late: ignored
  EXPECT_EQ(history.At(Time(FromSeconds(1.1))).left.pan_rad, 0.4);
  EXPECT_NEAR(history.At(Time(FromSeconds(1.025))).left.pan_rad, 0.25, 1e-12);
  EXPECT_EQ(history.At(Time(FromSeconds(9))).left.pan_rad, 0.4);
  EXPECT_EQ(history.At(Time(FromSeconds(0.5))).left.pan_rad, 0.2);
}

TEST(AngleHistory, ForgetsWhatIsOlderThanItsLength) {
  AngleHistory history(FromSeconds(1));
  for (int i = 0; i <= 30; ++i) history.Add(Reading(0.1 * i, 0.1 * i));
  EXPECT_NEAR(history.At(Time{}).left.pan_rad, 2.0, 1e-9);
}

}  // namespace
}  // namespace horopter::control
