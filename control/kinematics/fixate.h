// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "control/kinematics/fixation.h"
#include "hardware/types/head_angles.h"
#include "hardware/types/head_geometry.h"

namespace horopter::control {

/// Fixates with eyes that pan and tilt independently, the neck staying where it is (Koala).
///
/// Each optical axis passes through its eye's axes, so that an eye's angles are those of the
/// target seen from there, whatever the lever arm to the optical centre.
/// @param p_BT target in the base frame [m]
Fixation FixateWithEyes(const hardware::HeadGeometry& geometry, const hardware::HeadLimits& limits,
                        const hardware::PanTilt& neck, const Eigen::Vector3d& p_BT);

/// Fixates with neck pan, elevation and a vergence per eye (Yorick): the neck turns the eyes' plane
/// through the target, symmetrically in front, and the vergences meet there.
///
/// LookAt() with its defaults, for targets in front of the neck's pan axis.
///
/// A head without eye axes (NAO) gets the neck's angles alone: the middle of its two parallel
/// optical axes then passes through the target.
Fixation FixateWithNeck(const hardware::HeadGeometry& geometry, const hardware::HeadLimits& limits,
                        const Eigen::Vector3d& p_BT);

/// The one of the two that the head's axes allow: with its eyes when they tilt on their own,
/// otherwise with its neck. @param neck where the neck stands, for heads that keep it there
Fixation Fixate(const hardware::HeadGeometry& geometry, const hardware::HeadLimits& limits,
                const hardware::PanTilt& neck, const Eigen::Vector3d& p_BT);

}  // namespace horopter::control
