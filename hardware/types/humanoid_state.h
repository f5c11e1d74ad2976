// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "hardware/types/pose.h"
#include "hardware/types/time.h"

namespace horopter::hardware {

/// Walking velocity in the robot's own frame: forward, to its left, turning left.
struct WalkVelocity {
  double forward_m_s = 0;
  double left_m_s = 0;
  double turn_rad_s = 0;
};

/// What a humanoid reports of itself.
struct HumanoidState {
  Time t{};
  /// In the order of HumanoidProperties::joints [rad; a hand from 0, closed, to 1, open].
  std::vector<double> joint_position;
  /// Planar pose of the robot in its pose at the first Configure(), by dead reckoning of its steps.
  /// Feet slip: it drifts from the truth.
  Pose2 odometry;
  bool walking = false;  ///< from a command on until the last step is done and the robot stands
};

/// One joint by the robot's own name.
struct HumanoidJoint {
  std::string name;
  double min_rad = 0;
  double max_rad = 0;
  double max_speed_rad_s = 0;
};

/// What a humanoid is, for whoever plans its motion.
struct HumanoidProperties {
  std::vector<HumanoidJoint> joints;
  WalkVelocity max_velocity;  ///< of each component by itself, either way
  Duration max_stop_time{};   ///< from Stop() at any speed to standing
};

}  // namespace horopter::hardware
