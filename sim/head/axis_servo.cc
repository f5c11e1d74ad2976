// SPDX-License-Identifier: Apache-2.0
#include "sim/head/axis_servo.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>

#include "hardware/types/config_error.h"

namespace horopter::sim {

namespace {

std::vector<hardware::FieldError> Validate(const hardware::AxisLimits& limits) {
  std::vector<hardware::FieldError> errors;
  const auto require = [&errors](bool good, const char* field, double value, const char* rule) {
    if (!good) errors.push_back({field, std::to_string(value), rule});
  };
  require(std::isfinite(limits.min_rad), "axis.min_rad", limits.min_rad, "must be finite");
  require(std::isfinite(limits.max_rad) && limits.max_rad >= limits.min_rad, "axis.max_rad",
          limits.max_rad, "must be finite and at least min_rad");
  require(std::isfinite(limits.max_speed_rad_s) && limits.max_speed_rad_s > 0,
          "axis.max_speed_rad_s", limits.max_speed_rad_s, "must be finite and positive");
  require(std::isfinite(limits.max_acceleration_rad_s2) && limits.max_acceleration_rad_s2 > 0,
          "axis.max_acceleration_rad_s2", limits.max_acceleration_rad_s2,
          "must be finite and positive");
  return errors;
}

}  // namespace

AxisServo::AxisServo(const hardware::AxisLimits& limits, double position_rad) : limits_(limits) {
  hardware::ThrowIfAny(Validate(limits));
  position_ = target_ = std::clamp(position_rad, limits.min_rad, limits.max_rad);
}

void AxisServo::SetTarget(double target_rad) {
  assert(std::isfinite(target_rad));
  target_ = std::clamp(target_rad, limits_.min_rad, limits_.max_rad);
}

AxisServo::Plan AxisServo::MakePlan() const {
  const double a = limits_.max_acceleration_rad_s2;
  const double stop = position_ + speed_ * std::abs(speed_) / (2 * a);
  // Below this a stop counts as on the target: rounding must not send a braking axis back and
  // forth.
  constexpr double kSame_rad = 1e-12;
  if (std::abs(target_ - stop) < kSame_rad) {
    return {speed_ < 0 ? -1.0 : 1.0, std::abs(speed_), 0, 0, std::abs(speed_) / a};
  }
  const double direction = target_ > stop ? 1 : -1;
  const double way = direction * (target_ - position_);
  const double speed = direction * speed_;
  const double unlimited_peak = std::sqrt(std::max(0.0, a * way + speed * speed / 2));
  const double peak = std::min(unlimited_peak, limits_.max_speed_rad_s);
  const double ramps = (2 * peak * peak - speed * speed) / (2 * a);
  const double cruise = unlimited_peak > peak ? std::max(0.0, (way - ramps) / peak) : 0;
  return {direction, peak, std::max(0.0, (peak - speed) / a), cruise, peak / a};
}

double AxisServo::TimeToTarget() const {
  const Plan plan = MakePlan();
  return plan.speed_up_s + plan.cruise_s + plan.slow_down_s;
}

void AxisServo::Advance(double dt_s) {
  assert(dt_s >= 0);
  const double a = limits_.max_acceleration_rad_s2;
  const Plan plan = MakePlan();
  const double left_s = plan.speed_up_s + plan.cruise_s + plan.slow_down_s - dt_s;
  if (left_s <= 0) {
    position_ = target_;
    speed_ = 0;
  } else if (left_s <= plan.slow_down_s) {
    // Measured back from the target, so that it is reached exactly and from the right side.
    position_ = target_ - plan.direction * a * left_s * left_s / 2;
    speed_ = plan.direction * a * left_s;
  } else if (dt_s >= plan.speed_up_s) {
    const double before_braking_s = left_s - plan.slow_down_s;
    const double braking_way = plan.peak_rad_s * plan.peak_rad_s / (2 * a);
    position_ = target_ - plan.direction * (braking_way + plan.peak_rad_s * before_braking_s);
    speed_ = plan.direction * plan.peak_rad_s;
  } else {
    position_ += (speed_ + plan.direction * a * dt_s / 2) * dt_s;
    speed_ += plan.direction * a * dt_s;
  }
}

}  // namespace horopter::sim
