// SPDX-License-Identifier: Apache-2.0
#include "control/kinematics/angle_history.h"

#include <algorithm>

namespace horopter::control {

using hardware::HeadReading;
using hardware::Time;

void AngleHistory::Add(const HeadReading& reading) {
  if (!readings_.empty() && reading.t <= readings_.back().t) return;
  readings_.push_back(reading);
  while (readings_.front().t < reading.t - length_) readings_.pop_front();
}

hardware::HeadAngles AngleHistory::At(Time t) const {
  if (readings_.empty()) return {};
  const auto after = std::lower_bound(readings_.begin(), readings_.end(), t,
                                      [](const HeadReading& r, Time when) { return r.t < when; });
  if (after == readings_.end()) return readings_.back().angles;
  if (after == readings_.begin() || after->t == t) return after->angles;
  const HeadReading& before = *(after - 1);
  const double share = hardware::ToSeconds(t - before.t) / hardware::ToSeconds(after->t - before.t);
  hardware::HeadAxisArray angles = hardware::ToArray(before.angles);
  const hardware::HeadAxisArray next = hardware::ToArray(after->angles);
  for (std::size_t i = 0; i < angles.size(); ++i) angles[i] += share * (next[i] - angles[i]);
  return hardware::FromArray(angles);
}

}  // namespace horopter::control
