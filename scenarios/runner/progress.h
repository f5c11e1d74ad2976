// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <ostream>
#include <string>
#include <vector>

#include "scenarios/results/run_record.h"

namespace horopter::scenarios {

/// The progress line of a suite. On a terminal one line that is written over; otherwise a line now
/// and then, so that a log stays short.
class Progress {
 public:
  struct State {
    double done_sim_s = 0;
    double total_sim_s = 0;  ///< by the scenarios' time limits: most runs need less
    int done_runs = 0;
    int runs = 0;
    std::vector<std::string> doing;  ///< one for each run under way
  };

  Progress(std::ostream& out, bool terminal);

  void Show(const State& state);
  void Ended(const RunSummary& run);

  /// Takes the line away.
  void Clear();

 private:
  using WallClock = std::chrono::steady_clock;

  std::string TimeLeft(const State& state) const;

  std::ostream& out_;
  bool terminal_;
  WallClock::time_point start_ = WallClock::now();
  WallClock::time_point next_;
};

}  // namespace horopter::scenarios
