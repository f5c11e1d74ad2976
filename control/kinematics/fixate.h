// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "hardware/types/head_angles.h"
#include "hardware/types/head_geometry.h"

namespace horopter::control {

/// Why a head cannot fixate a point.
enum class FixationFault {
  kNone,
  kNotFinite,
  kBehind,        ///< not in front of the axes that would have to turn towards it
  kTooClose,      ///< nearer than half the baseline, or inside the head's own lever arms
  kBeyondLimits,  ///< an axis cannot turn so far
};

/// Angles that point both eyes at a target, or why there are none.
struct Fixation {
  /// What to command. Within the limits always: beyond them every axis is clamped, which looks
  /// as near the target as each axis can. With kNotFinite, kBehind or kTooClose it is the neck
  /// given and zero eyes.
  hardware::HeadAngles angles;
  FixationFault fault = FixationFault::kNone;
  std::optional<hardware::HeadAxis> axis;  ///< the first axis beyond its limits, with kBeyondLimits
  std::string why;                         ///< one line with the numbers; empty when reachable

  bool reachable() const { return fault == FixationFault::kNone; }
};

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
/// Closed form of the four-axis model (Davison's SceneLib, "full Yorick"), in body axes: with the
/// target (x, y, z) seen from the neck's pan axis, pan = atan2(y, x) and r = hypot(x, y) come
/// first, then, with A = hypot(r, z - pan_to_tilt), elevation = atan2(z - pan_to_tilt, r) -
/// asin(tilt_to_eyes / A), and the vergences -+atan2(baseline / 2, sqrt(A^2 - tilt_to_eyes^2)).
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
