// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hardware/interfaces/device.h"
#include "hardware/types/head_angles.h"
#include "hardware/types/time.h"

namespace horopter::hardware {

/// Angles as the encoders report them, and when.
struct HeadReading {
  Time t{};
  HeadAngles angles;
};

/// A head that turns two cameras.
///
/// Contract (besides Device's):
/// - Read() is allowed when inactive or active. Readings carry non-decreasing times and include
///   what the encoders do to the angle (quantisation, noise): they are not the truth.
/// - Command() sets the target of every axis and returns at once; the axes take the time that
///   their limits need. Targets beyond an axis' limits are clamped to them, on axes that do not
///   exist ignored; a target that is not finite is refused whole with kOutOfRange. Refused with
///   kNotActive unless active. A new command replaces the old one.
/// - Where an axis' range depends on another's angle (NAO's pitch on its yaw), limits() is its
///   widest, and the axis stays within its range at every angle on the way.
/// - With targets constant, the readings settle within one encoder step of the clamped targets.
class StereoHead : public Device {
 public:
  virtual Result<HeadReading> Read() = 0;
  virtual Result<void> Command(const HeadAngles& target) = 0;
  virtual HeadLimits limits() const = 0;
};

}  // namespace horopter::hardware
