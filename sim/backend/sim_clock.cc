// SPDX-License-Identifier: Apache-2.0
#include "sim/backend/sim_clock.h"

#include <chrono>

namespace horopter::sim {
namespace {

using WallClock = std::chrono::steady_clock;

double Milliseconds(WallClock::duration d) {
  return std::chrono::duration<double, std::milli>(d).count();
}

}  // namespace

SimClock::SimClock(const World& world, std::function<void()> step, hardware::StageTimes& times)
    : world_(world), step_(std::move(step)), times_(times), zero_(world.now().time_since_epoch()) {}

void SimClock::SleepUntil(hardware::Time t) {
  if (Now() >= t) return;
  const auto begun = WallClock::now();
  WallClock::duration observing{};
  while (Now() < t) {
    step_();
    for (const auto& part : parts_) part();
    if (observers_.empty()) continue;
    const auto stepped = WallClock::now();
    for (const auto& observer : observers_) observer(world_);
    observing += WallClock::now() - stepped;
  }
  times_.Add("physics", Milliseconds(WallClock::now() - begun - observing));
  if (!observers_.empty()) times_.Add("truth", Milliseconds(observing));
}

}  // namespace horopter::sim
