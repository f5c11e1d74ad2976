// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "control/kinematics/fixation.h"
#include "hardware/types/head_angles.h"

namespace horopter::control {

/// Where a head looks, whatever turns it.
struct GazeAngles {
  hardware::PanTilt version;  ///< of both eyes together: the neck's where there is one
  double vergence_rad = 0;    ///< angle between the optical axes, positive when they converge
};

/// The axes' angles for a gaze: version by the neck where it pans, otherwise by both eyes alike,
/// and half the vergence by each eye.
/// @return kBeyondLimits, with every axis clamped, when an axis cannot turn so far or is not there
Fixation Turn(const GazeAngles& gaze, const hardware::HeadLimits& limits);

}  // namespace horopter::control
