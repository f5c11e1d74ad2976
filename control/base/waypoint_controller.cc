// SPDX-License-Identifier: Apache-2.0
#include "control/base/waypoint_controller.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "hardware/types/field_checker.h"

namespace horopter::control {

using hardware::Pose2;
using hardware::Time;

std::vector<hardware::FieldError> WaypointControllerConfig::Validate() const {
  hardware::FieldChecker check("controller.");
  check.Part(linear.Validate("linear"));
  check.Part(angular.Validate("angular"));
  check.Require(turn_in_place_rad > 0 && turn_in_place_rad <= M_PI / 2, "turn_in_place_rad",
                turn_in_place_rad, "must be above 0 and at most pi/2");
  check.Require(std::isfinite(arrival_m) && arrival_m > 0, "arrival_m", arrival_m,
                "must be finite and positive");
  check.Require(min_forward_m_s >= 0 && min_forward_m_s <= linear.output_limit, "min_forward_m_s",
                min_forward_m_s, "must be between 0 and linear.output_limit");
  return check.Take();
}

WaypointController::WaypointController(const WaypointControllerConfig& config)
    : config_((hardware::ThrowIfAny(config.Validate()), config)),
      linear_(config.linear),
      angular_(config.angular) {}

void WaypointController::SetTarget(const Eigen::Vector2d& p_OT) {
  if (p_OT_ && *p_OT_ == p_OT) return;
  p_OT_ = p_OT;
  last_.reset();
  linear_.Reset();
  angular_.Reset();
}

WaypointController::Output WaypointController::Update(Time t, const Pose2& X_OB) {
  Output output;
  if (!p_OT_) {
    output.arrived = true;
    return output;
  }
  const double dt_s = last_ ? std::max(0.0, hardware::ToSeconds(t - *last_)) : 0.0;
  last_ = t;

  const Eigen::Vector2d to_target = *p_OT_ - Eigen::Vector2d(X_OB.x_m, X_OB.y_m);
  output.distance_m = to_target.norm();
  if (output.distance_m <= config_.arrival_m) {
    output.arrived = true;
    return output;
  }
  output.heading_error_rad =
      hardware::WrapAngle(std::atan2(to_target.y(), to_target.x()) - X_OB.heading_rad);
  output.turning_in_place = std::abs(output.heading_error_rad) > config_.turn_in_place_rad;
  output.command.turn_rad_s = angular_.Update(output.heading_error_rad, dt_s);
  if (output.turning_in_place) {
    linear_.Reset();  // or its integral would grow while it must not act
  } else {
    const double forward =
        std::max(linear_.Update(output.distance_m, dt_s), config_.min_forward_m_s);
    output.command.forward_m_s = forward * std::cos(output.heading_error_rad);
  }
  return output;
}

}  // namespace horopter::control
