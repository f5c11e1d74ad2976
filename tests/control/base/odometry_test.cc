// SPDX-License-Identifier: Apache-2.0
#include "control/base/odometry.h"

#include <gtest/gtest.h>

#include <cmath>

#include "control/base/unicycle.h"

namespace horopter::control {
namespace {

using hardware::BaseState;
using hardware::Pose2;
using hardware::Time;
using std::chrono::milliseconds;

const hardware::BaseProperties kKoala{4.5e-5, 0.31, 0.571};

BaseState At(int ms, std::int64_t left, std::int64_t right) {
  return {Time(milliseconds(ms)), left, right, {}};
}

TEST(Odometry, FirstReadingIsTheReference) {
  Odometry odometry(kKoala);
  EXPECT_EQ(odometry.Update(At(0, 1234, -99)).x_m, 0);
  EXPECT_NEAR(odometry.Update(At(20, 1334, 1)).x_m, 100 * 4.5e-5, 1e-15);
}

TEST(Odometry, FollowsAConstantArcExactlyUpToPulses) {
  Odometry odometry(kKoala);
  const double left = 0.20, right = 0.26;
  for (int ms = 0; ms <= 10000; ms += 20) {
    const double t = ms / 1000.0;
    odometry.Update(At(ms, std::llround(left * t / 4.5e-5), std::llround(right * t / 4.5e-5)));
  }
  const Pose2 expected = AlongArc({}, 2.3, 0.6 / 0.31);
  EXPECT_NEAR(odometry.pose().x_m, expected.x_m, 2e-4);
  EXPECT_NEAR(odometry.pose().y_m, expected.y_m, 2e-4);
  EXPECT_NEAR(odometry.pose().heading_rad, expected.heading_rad, 3e-4);
  EXPECT_NEAR(odometry.travelled_m(), 2.3, 1e-3);
}

TEST(Odometry, OldReadingsAreIgnored) {
  Odometry odometry(kKoala);
  odometry.Update(At(0, 0, 0));
  odometry.Update(At(40, 1000, 1000));
  odometry.Update(At(20, 9000, 0));
  odometry.Update(At(40, 9000, 0));
  EXPECT_NEAR(odometry.pose().x_m, 0.045, 1e-12);
  EXPECT_EQ(odometry.pose().heading_rad, 0);
}

TEST(Odometry, KnowsWhereItWasBetweenReadings) {
  Odometry odometry(kKoala);
  EXPECT_FALSE(odometry.PoseAt(Time{}).has_value());
  for (int i = 0; i <= 10; ++i) odometry.Update(At(100 + 20 * i, 200 * i, 260 * i));
  EXPECT_FALSE(odometry.PoseAt(Time(milliseconds(99))).has_value());
  const Pose2 half = *odometry.PoseAt(Time(milliseconds(190)));
  const Pose2 expected = AlongArc({}, 4.5 * 230 * 4.5e-5, 4.5 * 60 * 4.5e-5 / 0.31);
  EXPECT_NEAR(half.x_m, expected.x_m, 1e-12);
  EXPECT_NEAR(half.y_m, expected.y_m, 1e-12);
  EXPECT_NEAR(half.heading_rad, expected.heading_rad, 1e-12);
  EXPECT_EQ(odometry.PoseAt(Time(milliseconds(9999)))->x_m, odometry.pose().x_m);
}

TEST(Odometry, HistoryIsBounded) {
  Odometry odometry(kKoala, milliseconds(100));
  for (int i = 0; i <= 100; ++i) odometry.Update(At(20 * i, 10 * i, 10 * i));
  EXPECT_TRUE(odometry.PoseAt(Time(milliseconds(1900))).has_value());
  EXPECT_FALSE(odometry.PoseAt(Time(milliseconds(1800))).has_value());
}

TEST(Odometry, RefusesABaseWithoutATrack) {
  EXPECT_THROW(Odometry({4.5e-5, 0, 0.5}), hardware::ConfigError);
}

}  // namespace
}  // namespace horopter::control
