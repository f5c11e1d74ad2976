// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hardware/types/head_angles.h"

namespace horopter::sim {

/// Range of NAO's head pitch, positive down [rad].
struct PitchRange {
  double min_rad;
  double max_rad;
};

/// How far the head can pitch at a yaw before it meets the shoulders: Aldebaran's table of
/// anti-collision limits over |yaw|, linear between its rows and constant beyond the last.
PitchRange NaoPitchRange(double yaw_rad);

/// The axes of NAO's head in the order of hardware::HeadAxis: yaw as neck pan, pitch as neck tilt,
/// no axes of the eyes. Ranges and speeds are those of the joint table, the pitch's being its
/// widest, at yaw 0; the acceleration is the motion controller's, set by us.
hardware::HeadLimits NaoHeadLimits();

/// The target that the robot goes to when commanded one: within the axes' limits, and the pitch
/// within its range at that yaw. Angles of axes that NAO lacks come back as zero.
hardware::HeadAngles NaoReachable(const hardware::HeadAngles& target);

}  // namespace horopter::sim
