// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hardware/types/head_angles.h"

namespace horopter::sim {

/// The profile generator of one axis: the fastest motion to a target within limits of position,
/// speed and acceleration (a trapezoid of speed, a triangle for short ways), ending at rest.
///
/// Piecewise exact: positions do not depend on the step. From rest it never overshoots. A new
/// target while moving is taken up from the current speed, turning back when it cannot stop in
/// time.
class AxisServo {
 public:
  /// Starts at rest at `position_rad`, clamped to the limits.
  /// @throws hardware::ConfigError when the limits are not finite, reversed, or allow no motion.
  AxisServo(const hardware::AxisLimits& limits, double position_rad);

  /// Sets where to go, clamped to the limits. @pre finite
  void SetTarget(double target_rad);

  /// Moves on by dt. @pre dt_s >= 0
  void Advance(double dt_s);

  double position_rad() const { return position_; }
  double speed_rad_s() const { return speed_; }
  double target_rad() const { return target_; }
  bool at_target() const { return position_ == target_ && speed_ == 0; }
  const hardware::AxisLimits& limits() const { return limits_; }

  /// How long the axis still moves if the target stays.
  double TimeToTarget() const;

 private:
  /// The motion from now on: speed up in `direction`, cruise, slow down to rest on the target.
  struct Plan {
    double direction;
    double peak_rad_s;
    double speed_up_s;
    double cruise_s;
    double slow_down_s;
  };
  Plan MakePlan() const;

  hardware::AxisLimits limits_;
  double position_ = 0;
  double speed_ = 0;
  double target_ = 0;
};

}  // namespace horopter::sim
