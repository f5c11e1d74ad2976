// SPDX-License-Identifier: Apache-2.0
#include "control/kinematics/gaze_angles.h"

namespace horopter::control {

using hardware::HeadAxis;

Fixation Turn(const GazeAngles& gaze, const hardware::HeadLimits& limits) {
  hardware::HeadAngles wanted;
  if (limits[static_cast<int>(HeadAxis::kNeckPan)].exists()) {
    wanted.neck = gaze.version;
  } else {
    wanted.left = wanted.right = gaze.version;
  }
  // Converging eyes turn towards each other: the left one to the right, which is negative.
  wanted.left.pan_rad -= gaze.vergence_rad / 2;
  wanted.right.pan_rad += gaze.vergence_rad / 2;
  return WithinLimits(wanted, limits, HeadAxis::kNeckPan);
}

}  // namespace horopter::control
