// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hardware/types/time.h"

namespace horopter::hardware {

/// The run's only source of time.
///
/// Contract:
/// - Now() never decreases and starts at zero.
/// - SleepUntil(t) returns when Now() >= t, at once when t has passed. In lockstep this call *is*
///   what lets simulated time advance: physics and events up to t have happened when it returns,
///   and Now() == t exactly (rounded up to a physics step where the world has steps).
/// - Nothing above this interface reads the wall clock to decide anything.
class Clock {
 public:
  virtual ~Clock() = default;

  virtual Time Now() const = 0;
  virtual void SleepUntil(Time t) = 0;
};

}  // namespace horopter::hardware
