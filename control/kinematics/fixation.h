// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "hardware/types/head_angles.h"

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

/// The answer for a target that no angles fixate. @param because completes "target (x, y, z) in the
/// base frame ..."
Fixation RefuseFixation(FixationFault fault, const hardware::PanTilt& neck,
                        const Eigen::Vector3d& p_BT, const std::string& because);

/// Clamps every axis of `wanted` to its limits and says which was the first beyond them.
/// @param first_axis axes before it keep their angle (a neck that is not moved)
Fixation WithinLimits(const hardware::HeadAngles& wanted, const hardware::HeadLimits& limits,
                      hardware::HeadAxis first_axis);

}  // namespace horopter::control
