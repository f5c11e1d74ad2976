// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "control/base/pid.h"
#include "hardware/types/pose.h"
#include "hardware/types/time.h"

namespace horopter::control {

/// Defaults suit a robot of the Koala's size (at most 0.57 m/s), well below its limits so that
/// wheels do not slip and vision keeps up.
struct WaypointControllerConfig {
  PidConfig linear{0.8, 0.0, 0.0, 0.25};   ///< distance [m] to forward speed [m/s]
  PidConfig angular{1.8, 0.0, 0.05, 0.8};  ///< heading difference [rad] to turn rate [rad/s]
  double turn_in_place_rad = 0.45;  ///< no forward motion while the heading is further off; more
                                    ///< than pi/10, so that an avoiding turn is driven as an arc
  double arrival_m = 0.05;          ///< the waypoint is reached within this distance
  double min_forward_m_s = 0.03;    ///< proportional control alone would creep up to the waypoint

  std::vector<hardware::FieldError> Validate() const;
};

/// Drives a unicycle to a point with two PID controllers, of distance and of heading difference
/// (Chessa et al. 2014, "Robot Modelling and Control").
///
/// Beyond the paper: the forward speed is scaled by the cosine of the heading difference and is
/// zero beyond `turn_in_place_rad`, since a unicycle whose point lies abeam would circle it.
class WaypointController {
 public:
  /// @throws hardware::ConfigError
  explicit WaypointController(const WaypointControllerConfig& config);

  struct Output {
    hardware::Twist2 command;
    double distance_m = 0;
    double heading_error_rad = 0;  ///< positive: the point is to the left
    bool turning_in_place = false;
    bool arrived = false;  ///< the command is then zero
  };

  /// A new point in the odometry frame O [m]; the controllers start afresh when it differs.
  void SetTarget(const Eigen::Vector2d& p_OT);

  /// @param X_OB the robot's pose in O
  /// @return a zero command, arrived, when no target has been set
  Output Update(hardware::Time t, const hardware::Pose2& X_OB);

 private:
  WaypointControllerConfig config_;
  Pid linear_;
  Pid angular_;
  std::optional<Eigen::Vector2d> p_OT_;
  std::optional<hardware::Time> last_;
};

}  // namespace horopter::control
