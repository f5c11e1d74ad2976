// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scenarios/render/head_reach.h"

namespace horopter::scenarios {

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

/// Draws gazes uniformly; each quantity has its own stream. Where a head tilts less far at some
/// pans, tilts are drawn from what it reaches at the pan drawn, and pans at which it reaches none
/// of the bounds are drawn again.
/// @pre count >= 0
/// @throws hardware::ConfigError when the head reaches nothing of the bounds
std::vector<Gaze> SampleGazes(const GazeBounds& bounds, int count, std::uint64_t seed,
                              const HeadReach& reach);

}  // namespace horopter::scenarios
