// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "hardware/types/pose.h"

namespace horopter::scenarios {

/// Pose given to a movable body of the scene, in the robot's starting frame O: where the robot is
/// told that it is, whatever the seed did to its heading. The body turns by yaw about the vertical,
/// then by pitch about its own y axis, then by roll about its own x axis, all right-handed.
struct BodyPlacement {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  double yaw_deg = 0;    ///< counter-clockwise
  double pitch_deg = 0;  ///< positive: its front down
  double roll_deg = 0;   ///< positive: its left side up

  bool operator==(const BodyPlacement&) const = default;

  hardware::Pose X_OBody() const;
};

}  // namespace horopter::scenarios
