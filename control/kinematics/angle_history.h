// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>

#include "hardware/interfaces/stereo_head.h"
#include "hardware/types/head_angles.h"
#include "hardware/types/time.h"

namespace horopter::control {

/// Where a head pointed lately by its encoders, for images that arrive after they were taken.
class AngleHistory {
 public:
  /// @param length how far back it reaches
  explicit AngleHistory(hardware::Duration length = std::chrono::seconds(2)) : length_(length) {}

  /// Takes a reading; one no newer than the last is ignored.
  void Add(const hardware::HeadReading& reading);

  /// Each axis on the line between the readings around an instant; the newest reading for a later
  /// one, the oldest kept for an earlier one. Zero angles before the first reading.
  hardware::HeadAngles At(hardware::Time t) const;

 private:
  hardware::Duration length_;
  std::deque<hardware::HeadReading> readings_;
};

}  // namespace horopter::control
