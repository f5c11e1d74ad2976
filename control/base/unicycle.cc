// SPDX-License-Identifier: Apache-2.0
#include "control/base/unicycle.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "hardware/types/field_checker.h"

namespace horopter::control {

using hardware::BaseProperties;
using hardware::Pose2;
using hardware::Twist2;
using hardware::WheelSpeeds;

std::vector<hardware::FieldError> Validate(const BaseProperties& base) {
  hardware::FieldChecker check("base.");
  check.Positive("metres_per_pulse", base.metres_per_pulse);
  check.Positive("effective_track_m", base.effective_track_m);
  check.Positive("max_wheel_speed_m_s", base.max_wheel_speed_m_s);
  return check.Take();
}

WheelSpeeds FromTwist(const Twist2& twist, const BaseProperties& base) {
  const double half_difference = twist.turn_rad_s * base.effective_track_m / 2;
  WheelSpeeds speeds{twist.forward_m_s - half_difference, twist.forward_m_s + half_difference};
  const double fastest = std::max(std::abs(speeds.left_m_s), std::abs(speeds.right_m_s));
  if (fastest > base.max_wheel_speed_m_s) {
    speeds.left_m_s *= base.max_wheel_speed_m_s / fastest;
    speeds.right_m_s *= base.max_wheel_speed_m_s / fastest;
  }
  return speeds;
}

Twist2 ToTwist(const WheelSpeeds& speeds, const BaseProperties& base) {
  return {(speeds.left_m_s + speeds.right_m_s) / 2,
          (speeds.right_m_s - speeds.left_m_s) / base.effective_track_m};
}

Pose2 AlongArc(const Pose2& start, double forward_m, double turn_rad) {
  // The chord of the arc: its length is the arc's times sin(h) / h, its direction half the turn.
  const double h = turn_rad / 2;
  const double ratio = std::abs(h) < 1e-4 ? 1 - h * h / 6 : std::sin(h) / h;
  const double direction = start.heading_rad + h;
  return {start.x_m + forward_m * ratio * std::cos(direction),
          start.y_m + forward_m * ratio * std::sin(direction),
          hardware::WrapAngle(start.heading_rad + turn_rad)};
}

}  // namespace horopter::control
