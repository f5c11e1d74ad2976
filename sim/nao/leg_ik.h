// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hardware/types/eye.h"
#include "hardware/types/pose.h"

namespace horopter::sim {

/// Lengths of NAO's legs [m]. The three axes of a hip meet in a point, as do an ankle's two.
struct NaoLeg {
  static constexpr double kHipAside_m = 0.05;       ///< hip from the torso's middle plane
  static constexpr double kHipBelow_m = 0.085;      ///< hip below the torso's origin
  static constexpr double kThigh_m = 0.100;         ///< hip to knee
  static constexpr double kTibia_m = 0.1029;        ///< knee to ankle
  static constexpr double kFootHeight_m = 0.04519;  ///< ankle above the sole
};

/// NAO's leg joints, named and signed as NAOqi's [rad].
struct LegAngles {
  double hip_yaw_pitch = 0;
  double hip_roll = 0;
  double hip_pitch = 0;
  double knee_pitch = 0;
  double ankle_pitch = 0;
  double ankle_roll = 0;
};

/// The foot's pose in the torso, axes as the torso's at joint angles zero, origin in the ankle.
hardware::Pose LegForward(hardware::Eye side, const LegAngles& leg);

/// The leg that puts the ankle where `X_TF` has it and keeps the foot's plane, with the hip's
/// coupled joint given. The foot's heading is what that joint makes of it. An ankle out of reach is
/// reached for with a straight leg. In closed form; joint limits are not looked at.
LegAngles SolveLeg(hardware::Eye side, const hardware::Pose& X_TF, double hip_yaw_pitch);

/// The hip's coupled joint that gives the foot its heading too, by Newton's method to 1e-9 rad;
/// within the joint's range.
double SolveHipYawPitch(hardware::Eye side, const hardware::Pose& X_TF);

}  // namespace horopter::sim
