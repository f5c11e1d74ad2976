// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

#include "scenarios/format/scenario.h"
#include "scenarios/results/run_record.h"

namespace horopter::scenarios {

/// Simulated seconds that a scenario will take, about, before any run of it is known: what its
/// steps hold and wait, the turns of the head between them, and the ways from goal to goal at
/// cruise speed with a share for detours; no step longer than its timeout, the whole no longer than
/// the scenario's time limit.
double ExpectedSimSeconds(const Scenario& scenario);

/// What runs of a suite will take: the mean of those of the same scenario that have ended, and
/// ExpectedSimSeconds() before there is one.
class ExpectedTimes {
 public:
  /// A run that has ended, with any outcome; without `sim_s` it tells nothing.
  void Learn(const RunSummary& run);

  double Of(const Scenario& scenario) const;

 private:
  struct Sum {
    double sim_s = 0;
    int runs = 0;
  };
  std::map<std::string, Sum> by_scenario_;
};

}  // namespace horopter::scenarios
