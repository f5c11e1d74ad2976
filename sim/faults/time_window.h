// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hardware/types/time.h"

namespace horopter::sim {

/// When a fault is there: from `from` on, until just before `until`, on the run's time line.
///
/// A fault from time zero has always been there, also while the robot comes to rest before the run.
struct TimeWindow {
  hardware::Time from{};
  hardware::Time until = hardware::Time::max();

  bool Contains(hardware::Time t) const {
    return t < until && (t >= from || from <= hardware::Time{});
  }
};

}  // namespace horopter::sim
