// SPDX-License-Identifier: Apache-2.0
#include "sim/backend/sim_clock.h"

namespace horopter::sim {

SimClock::SimClock(const World& world, std::function<void()> step, hardware::StageTimes& times)
    : world_(world), step_(std::move(step)), times_(times), zero_(world.now().time_since_epoch()) {}

void SimClock::SleepUntil(hardware::Time t) {
  if (Now() >= t) return;
  times_.Measure("physics", [&] {
    while (Now() < t) {
      step_();
      for (const auto& observer : observers_) observer(world_);
    }
  });
}

}  // namespace horopter::sim
