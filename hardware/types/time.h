// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>

namespace horopter::hardware {

/// Tag of the run's time line: nanoseconds since the run's start, on whichever `Clock` paces it.
struct RunTimeline {};

using Duration = std::chrono::nanoseconds;

/// A point on the run's time line. Integer nanoseconds, so that sums do not depend on their order.
using Time = std::chrono::time_point<RunTimeline, Duration>;

constexpr double ToSeconds(Duration d) { return std::chrono::duration<double>(d).count(); }
constexpr double ToSeconds(Time t) { return ToSeconds(t.time_since_epoch()); }

/// Rounds to the nearest nanosecond. @pre |seconds| < 9.2e9.
constexpr Duration FromSeconds(double seconds) {
  return Duration(static_cast<std::int64_t>(seconds * 1e9 + (seconds >= 0 ? 0.5 : -0.5)));
}

}  // namespace horopter::hardware
