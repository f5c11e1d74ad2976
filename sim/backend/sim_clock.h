// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "hardware/interfaces/clock.h"
#include "hardware/types/stage_times.h"
#include "sim/world/world.h"

namespace horopter::sim {

/// The lockstep clock of a simulated robot: SleepUntil() is what steps physics.
///
/// Time zero is the world's time at construction, so build it once the robot has come to rest.
class SimClock final : public hardware::Clock {
 public:
  /// @param world outlives the clock, as does `times`
  /// @param step advances the whole robot by one physics step: its actuators' set points, then
  ///        World::Step()
  /// @param times books "physics" and, apart from it, what observers take as "truth"
  SimClock(const World& world, std::function<void()> step, hardware::StageTimes& times);

  hardware::Time Now() const override { return world_.now() - zero_; }
  void SleepUntil(hardware::Time t) override;

  /// Called after every physics step, in the order in which observers came.
  void OnStep(std::function<void(const World&)> observer) {
    observers_.push_back(std::move(observer));
  }

  /// Runs as part of every physics step, before any observer: for what belongs to the robot.
  void AfterStep(std::function<void()> part) { parts_.push_back(std::move(part)); }

  hardware::Duration step() const { return world_.step(); }

 private:
  const World& world_;
  std::function<void()> step_;
  hardware::StageTimes& times_;
  hardware::Duration zero_;  ///< world time at time zero
  std::vector<std::function<void()>> parts_;
  std::vector<std::function<void(const World&)>> observers_;
};

}  // namespace horopter::sim
