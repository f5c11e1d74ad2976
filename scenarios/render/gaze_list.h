// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "hardware/types/head_angles.h"

namespace horopter::scenarios {

/// Where a head looks, as people write it: pan positive left, tilt positive down, vergence the
/// angle between the optical axes.
struct Gaze {
  double pan_deg = 0;
  double tilt_deg = 0;
  double vergence_deg = 0;
};

/// From one value to another; both alike: that value.
struct Interval {
  double low = 0;
  double high = 0;
};

/// What gazes are drawn from.
struct GazeBounds {
  Interval pan_deg{-30, 30};
  Interval tilt_deg{-20, 20};
  Interval vergence_deg{0, 10};

  /// These bounds as far as the head's axes reach.
  GazeBounds Within(const hardware::HeadLimits& limits) const;
};

/// Reads "A" or "A:B".
/// @throws hardware::ConfigError naming `option` when it is neither, or B is less than A
Interval ParseInterval(const std::string& option, const std::string& text);

/// A CSV table with the header pan_deg,tilt_deg,vergence_deg.
/// @param name of the file, for messages
/// @throws FormatError naming file, line and field; also when there is no row
std::vector<Gaze> DecodeGazes(std::string_view text, const std::string& name);

/// Draws gazes uniformly; each quantity has its own stream. @pre count >= 0
std::vector<Gaze> SampleGazes(const GazeBounds& bounds, int count, std::uint64_t seed);

/// The head's angles.
/// @throws hardware::ConfigError naming the gaze when the head cannot turn so far
hardware::HeadAngles AnglesOf(const Gaze& gaze, const hardware::HeadLimits& limits);

}  // namespace horopter::scenarios
