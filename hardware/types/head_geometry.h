// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hardware/types/pose.h"

namespace horopter::hardware {

/// Where the axes of a stereo head are. Lengths in metres, body axes (x forward, y left, z up).
///
/// From base to optical centre: X_BN places the neck's pan axis in the base; `pan_to_tilt_m` up
/// from it and `pan_to_tilt_forward_m` forward (turned with the neck's pan) is the neck's tilt
/// axis; `tilt_to_eyes_m` up from that (turned with the neck's tilt) is the head frame H, midway
/// between the eyes' pan axes, which stand at y = +baseline/2 (left) and -baseline/2 (right); each
/// optical centre is `axis_to_optical_centre_m` forward of its axis along its own optical axis. The
/// last four lengths named here are P, C, I and N of the four-axis Yorick model; the Koala has all
/// but X_BN and the baseline zero, so that its optical centres lie on the axes, as equation (1) of
/// Chessa et al. 2014 has them.
struct HeadGeometry {
  Pose X_BN = Pose::Identity();
  double pan_to_tilt_m = 0;
  double tilt_to_eyes_m = 0;
  double baseline_m = 0;
  double axis_to_optical_centre_m = 0;
  double pan_to_tilt_forward_m = 0;
};

}  // namespace horopter::hardware
