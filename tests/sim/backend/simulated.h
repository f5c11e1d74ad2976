// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "hardware/interfaces/clock.h"
#include "hardware/interfaces/stereo_head.h"
#include "hardware/types/stage_times.h"
#include "hardware/types/time.h"

namespace horopter::sim {

/// What the contract suites' traits of every simulated robot have in common.
/// @tparam MakeConfig gives the simulation's configuration
template <typename Simulation, auto MakeConfig>
class Simulated {
 public:
  static constexpr bool kLockstep = true;

  hardware::Clock& clock() { return simulation_.clock(); }

 protected:
  const decltype(MakeConfig()) config_ = MakeConfig();
  hardware::StageTimes times_;
  Simulation simulation_{config_, times_};
};

template <typename Robot>
class SimulatedClock : public Robot {
 public:
  std::optional<hardware::Duration> step() { return this->simulation_.world().step(); }
};

template <typename Robot>
class SimulatedHead : public Robot {
 public:
  hardware::StereoHead& device() { return this->simulation_.head(); }
  hardware::HeadAxisArray encoder_tolerance_rad() const {
    hardware::HeadAxisArray steps;
    steps.fill(this->config_.head.encoder_resolution_rad);
    return steps;
  }
};

}  // namespace horopter::sim
