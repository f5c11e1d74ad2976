// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scenarios/format/metric_registry.h"
#include "scenarios/results/run_record.h"

namespace horopter::scenarios {

enum class Verdict { kSame, kWithinNoise, kBetter, kWorse };

/// A run or expectation that ended otherwise than before.
struct OutcomeChange {
  std::string run;          ///< "first waypoint, seed 3, sim"
  std::string expectation;  ///< "" = the run as a whole
  std::string before;       ///< passed, failed, error, incomplete, not_applicable
  std::string after;
  Verdict verdict = Verdict::kSame;
};

/// One run's metric on both sides.
struct SeedChange {
  std::uint64_t seed = 0;
  double before = 0;
  double after = 0;
  double worsening = 0;  ///< positive when worse
  double noise = 0;      ///< a worsening up to this is none
  Verdict verdict = Verdict::kSame;
};

/// A metric of a scenario on a backend, over the seeds that both sides played.
struct MetricChange {
  std::string scenario;
  std::string backend;
  std::string metric;
  std::string unit;
  int pairs = 0;
  double before = 0;                 ///< median over the pairs
  double after = 0;                  ///< likewise
  double worsening = 0;              ///< median of the paired differences, positive when worse
  double noise = 0;                  ///< a worsening up to this is none
  SeedChange worst;                  ///< the pair that worsened most
  Verdict verdict = Verdict::kSame;  ///< worse when the worst pair is, whatever the median does
};

/// A stage's time, as the ratio after / before of its medians.
struct TimingChange {
  std::string scenario;
  std::string backend;
  std::string stage;
  int pairs = 0;
  double before_ms = 0;
  double after_ms = 0;
  double ratio = 1;
  double noise = 0;  ///< a ratio up to 1 + noise is none
  Verdict verdict = Verdict::kSame;
};

struct SuiteComparison {
  int pairs = 0;                           ///< runs that both sides have
  std::vector<std::string> builds_before;  ///< that played the old runs, each once
  std::vector<std::string> builds_after;
  std::vector<std::string> missing;  ///< runs, and in them expectations and metrics, that only the
                                     ///< old side has
  std::vector<std::string> added;    ///< runs that only the new side has
  std::vector<OutcomeChange> outcomes;
  std::vector<MetricChange> metrics;
  std::vector<TimingChange> timings;

  bool OutcomesOrMetricsRegressed() const;
  bool TimingsRegressed() const;
};

/// Compares two suites run by run (scenario, seed, backend).
///
/// An outcome or expectation that is worse than before is a regression, from best to worst: passed,
/// not applicable, failed, incomplete, error. A metric is compared over all seeds of a scenario,
/// twice. Over all: the median of the paired differences against its own standard error
/// (MedianNoise), and never less than a floor: 1 % of the old median (10 % below three pairs, where
/// the spread is unknown) and 1 mm, 0.01 deg, 0.05 s or 0.001. And its worst pair, since a disaster
/// on one seed moves no median: against what the other pairs and the old runs scatter (PairNoise),
/// with the floor of 10 %. Counts are judged by their sum, which has no noise, and by their worst
/// pair. Timings are ratios, on a logarithmic scale, with a floor of 25 % and 0.5 ms: other load on
/// the machine is no regression.
/// @throws UnusableResults when two runs of one side share scenario, seed and backend
SuiteComparison Compare(const std::vector<RunSummary>& before,
                        const std::vector<RunSummary>& after);

/// How much worse `after` is than `before`, in the metric's unit; negative when better.
double Worsening(const Metric& metric, double before, double after);

}  // namespace horopter::scenarios
