// SPDX-License-Identifier: Apache-2.0
#include "sim/head/axis_servo.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "hardware/types/config_error.h"
#include "sim/random/random_stream.h"

namespace horopter::sim {
namespace {

constexpr hardware::AxisLimits kAxis{-2, 1.5, 2, 10};

TEST(AxisServo, FromRestTakesTheTrapezoidsTimeAndStopsOnTheTarget) {
  for (const double way : {1e-6, 0.01, 0.3, 0.4, 0.5, 1.4}) {
    AxisServo servo(kAxis, 0);
    servo.SetTarget(way);
    const bool cruises = way > 2.0 * 2.0 / 10;
    const double expected = cruises ? way / 2 + 2.0 / 10 : 2 * std::sqrt(way / 10);
    EXPECT_NEAR(servo.TimeToTarget(), expected, 1e-12);
    servo.Advance(expected * (1 - 1e-6));
    EXPECT_FALSE(servo.at_target());
    servo.Advance(expected * 2e-6);
    EXPECT_EQ(servo.position_rad(), way);
    EXPECT_EQ(servo.speed_rad_s(), 0);
  }
}

TEST(AxisServo, PositionsDoNotDependOnTheStep) {
  RandomStream random(1, "test");
  for (int i = 0; i < 200; ++i) {
    AxisServo coarse(kAxis, random.Uniform(-2, 1.5));
    coarse.SetTarget(random.Uniform(-2, 1.5));
    coarse.Advance(random.Uniform(0, 0.5));  // moving, perhaps
    coarse.SetTarget(random.Uniform(-2, 1.5));
    AxisServo fine = coarse;
    coarse.Advance(0.5);
    for (int k = 0; k < 500; ++k) fine.Advance(0.001);
    EXPECT_NEAR(coarse.position_rad(), fine.position_rad(), 1e-9);
    EXPECT_NEAR(coarse.speed_rad_s(), fine.speed_rad_s(), 1e-6);
  }
}

TEST(AxisServo, SpeedIsTheDerivativeOfPositionAndKeepsItsLimits) {
  RandomStream random(2, "test");
  AxisServo servo(kAxis, 0);
  constexpr double kStep_s = 1e-3;
  for (int i = 0; i < 20000; ++i) {
    if (i % 137 == 0) servo.SetTarget(random.Uniform(-2, 1.5));
    const double position = servo.position_rad();
    const double speed = servo.speed_rad_s();
    servo.Advance(kStep_s);
    const double change = servo.speed_rad_s() - speed;
    ASSERT_LE(std::abs(servo.speed_rad_s()), kAxis.max_speed_rad_s + 1e-12);
    ASSERT_LE(std::abs(change), kAxis.max_acceleration_rad_s2 * kStep_s + 1e-9);
    // A step that ends or turns a ramp is not of constant acceleration.
    const double trapezoid = (speed + servo.speed_rad_s()) / 2 * kStep_s;
    ASSERT_NEAR(servo.position_rad() - position, trapezoid, 10 * kStep_s * kStep_s);
  }
}

TEST(AxisServo, NeverOvershootsFromRest) {
  RandomStream random(3, "test");
  for (int i = 0; i < 200; ++i) {
    const double start = random.Uniform(-2, 1.5);
    const double target = random.Uniform(-2, 1.5);
    AxisServo servo(kAxis, start);
    servo.SetTarget(target);
    double last = start;
    for (int k = 0; k < 3000 && !servo.at_target(); ++k) {
      servo.Advance(random.Uniform(0, 0.004));
      const double forward = target > start ? 1 : -1;
      ASSERT_GE(forward * (servo.position_rad() - last), 0);
      ASSERT_LE(forward * (servo.position_rad() - target), 0);
      last = servo.position_rad();
    }
    EXPECT_TRUE(servo.at_target());
  }
}

TEST(AxisServo, TurnsBackWhenTheNewTargetIsTooCloseToStopAt) {
  AxisServo servo(kAxis, 0);
  servo.SetTarget(1.4);
  servo.Advance(0.3);  // at full speed; stopping takes 0.2 rad
  const double here = servo.position_rad();
  servo.SetTarget(here + 0.05);
  double farthest = here;
  for (int i = 0; i < 1000; ++i) {
    servo.Advance(0.001);
    farthest = std::max(farthest, servo.position_rad());
  }
  EXPECT_NEAR(farthest, here + 0.2, 1e-4);
  EXPECT_EQ(servo.position_rad(), here + 0.05);
}

TEST(AxisServo, ClampsTargetsToItsLimits) {
  AxisServo servo(kAxis, 7);
  EXPECT_EQ(servo.position_rad(), 1.5);
  servo.SetTarget(-100);
  servo.Advance(60);
  EXPECT_EQ(servo.position_rad(), -2);
}

TEST(AxisServo, RefusesLimitsThatAllowNoMotion) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(AxisServo({1, -1, 1, 1}, 0), hardware::ConfigError);
  EXPECT_THROW(AxisServo({-1, 1, 0, 1}, 0), hardware::ConfigError);
  EXPECT_THROW(AxisServo({-1, 1, 1, nan}, 0), hardware::ConfigError);
}

}  // namespace
}  // namespace horopter::sim
