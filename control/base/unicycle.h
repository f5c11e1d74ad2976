// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "hardware/types/base_state.h"
#include "hardware/types/config_error.h"
#include "hardware/types/pose.h"

namespace horopter::control {

/// Every bad field: all three are finite and positive.
std::vector<hardware::FieldError> Validate(const hardware::BaseProperties& base);

/// Wheel speeds of a unicycle with the base's effective track; beyond the maximum both are scaled
/// down together, so that the curvature is kept.
hardware::WheelSpeeds FromTwist(const hardware::Twist2& twist,
                                const hardware::BaseProperties& base);

/// The motion that wheel speeds make.
hardware::Twist2 ToTwist(const hardware::WheelSpeeds& speeds, const hardware::BaseProperties& base);

/// Where a unicycle is after it has driven an arc of length `forward_m` (of its centre) while
/// turning left by `turn_rad`. Exact for constant speeds.
hardware::Pose2 AlongArc(const hardware::Pose2& start, double forward_m, double turn_rad);

}  // namespace horopter::control
