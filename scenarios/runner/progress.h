// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <ostream>
#include <string>
#include <vector>

#include "scenarios/results/run_record.h"

namespace horopter::scenarios {

/// "about 2 min 5 s left", at the pace so far; "" while there is no pace yet.
std::string TimeLeft(double elapsed_s, double done_sim_s, double total_sim_s);

/// The progress line of a suite. On a terminal one line that is written over; otherwise a line now
/// and then, so that a log stays short.
class Progress {
 public:
  /// Where the suite is, run by run. Simulated time stands for work: a run that has ended counts
  /// with what it took, one that has not with what it is expected to take.
  struct State {
    double done_sim_s = 0;
    double total_sim_s = 0;
    int done_runs = 0;
    int runs = 0;
    std::vector<std::string> doing;  ///< one for each run under way

    void AddKept();  ///< of an earlier suite (--resume): no work of this one
    void AddEnded(const RunSummary& run);
    void AddWaiting(double expected_s);
    /// One that takes longer than expected will take some more.
    void AddUnderWay(double sim_s, double expected_s, std::string what);
  };

  Progress(std::ostream& out, bool terminal);

  void Show(const State& state);
  void Ended(const RunSummary& run);

  /// Takes the line away.
  void Clear();

 private:
  using WallClock = std::chrono::steady_clock;

  std::ostream& out_;
  bool terminal_;
  WallClock::time_point start_ = WallClock::now();
  WallClock::time_point next_;
};

}  // namespace horopter::scenarios
