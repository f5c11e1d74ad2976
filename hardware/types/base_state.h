// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "hardware/types/time.h"

namespace horopter::hardware {

/// Speed of the ground under each side's wheels, positive forward [m/s].
struct WheelSpeeds {
  double left_m_s = 0;
  double right_m_s = 0;
};

/// What a base reports of itself.
struct BaseState {
  Time t{};
  std::int64_t left_pulses = 0;   ///< encoder count since activation, unwrapped
  std::int64_t right_pulses = 0;  ///< likewise
  std::vector<int> proximity;     ///< raw sensor values, in the order of the robot's protocol
};

/// What a base is, for whoever plans its motion.
struct BaseProperties {
  double metres_per_pulse = 0;
  double effective_track_m = 0;  ///< wheel distance of the unicycle that turns as the base does
  double max_wheel_speed_m_s = 0;
};

}  // namespace horopter::hardware
