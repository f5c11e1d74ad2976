// SPDX-License-Identifier: Apache-2.0
#include "scenarios/results/timing_notice.h"

#include <fmt/format.h>

#include <map>
#include <utility>

namespace horopter::scenarios {
namespace {

/// The slowest run of a stage that is slower than modelled, and how many such runs there are.
struct Slowest {
  const RunSummary* run = nullptr;
  const StageTiming* timing = nullptr;
  int runs = 0;
};

bool IsSlower(const StageTiming& timing) {
  return timing.modelled_ms && timing.p95_ms && *timing.p95_ms > *timing.modelled_ms;
}

std::string Sentence(const std::string& stage, const Slowest& slowest) {
  const std::string others =
      slowest.runs > 1 ? fmt::format(" (the slowest of {} such runs)", slowest.runs) : "";
  return fmt::format(
      "{} seed {}{}: '{}' took {:.0f} ms at its 95th percentile where {:.0f} ms are modelled; for "
      "results that hold on this machine, model more (vision.latency_s)",
      slowest.run->scenario, slowest.run->seed, others, stage, *slowest.timing->p95_ms,
      *slowest.timing->modelled_ms);
}

}  // namespace

std::vector<std::string> TimingNotices(const std::vector<RunSummary>& runs) {
  std::map<std::pair<std::string, std::string>, Slowest> by_scenario_and_stage;
  for (const RunSummary& run : runs) {
    for (const auto& [stage, timing] : run.timing_ms) {
      if (!IsSlower(timing)) continue;
      Slowest& slowest = by_scenario_and_stage[{run.scenario, stage}];
      ++slowest.runs;
      if (slowest.run != nullptr && *timing.p95_ms <= *slowest.timing->p95_ms) continue;
      slowest.run = &run;
      slowest.timing = &timing;
    }
  }
  std::vector<std::string> notices;
  for (const auto& [key, slowest] : by_scenario_and_stage) {
    notices.push_back(Sentence(key.second, slowest));
  }
  return notices;
}

}  // namespace horopter::scenarios
