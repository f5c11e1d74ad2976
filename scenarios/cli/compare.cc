// SPDX-License-Identifier: Apache-2.0
#include "scenarios/cli/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "scenarios/cli/paired_noise.h"
#include "scenarios/results/results_error.h"
#include "scenarios/results/run_record.h"

namespace horopter::scenarios {
namespace {

constexpr double kFloorFew = 0.10;
constexpr double kFloorMany = 0.01;
constexpr double kTimingFloor = 0.25;
constexpr double kTimingFloor_ms = 0.5;

using RunKey = std::tuple<std::string, std::string, std::uint64_t>;  // scenario, backend, seed
using RunPair = std::pair<const RunSummary*, const RunSummary*>;
using GroupKey = std::pair<std::string, std::string>;  // scenario, backend

std::string Title(const RunSummary& run) {
  return fmt::format("{}, seed {}, {}", run.scenario, run.seed, run.backend);
}

std::map<RunKey, const RunSummary*> ByKey(const std::vector<RunSummary>& runs) {
  std::map<RunKey, const RunSummary*> map;
  for (const RunSummary& run : runs) {
    const auto [same, fresh] = map.emplace(RunKey{run.scenario, run.backend, run.seed}, &run);
    if (fresh) continue;
    throw UnusableResults(fmt::format(
        "two runs are both '{}', {} and {}: give one scenario another `name:` and play it again",
        Title(run), same->second->directory, run.directory));
  }
  return map;
}

double SmallestStep(const Metric& metric) {
  if (metric.unit == "m") return 1e-3;
  if (metric.unit == "deg") return 0.01;
  return metric.unit == "s" ? 0.05 : 1e-3;
}

Verdict Judge(double worsening, double noise) {
  if (worsening == 0) return Verdict::kSame;
  if (std::abs(worsening) <= noise) return Verdict::kWithinNoise;
  return worsening > 0 ? Verdict::kWorse : Verdict::kBetter;
}

/// How bad an outcome is: what was judged and failed is worth more than what was never judged.
int Badness(Outcome outcome) {
  switch (outcome) {
    case Outcome::kPassed:
      return 0;
    case Outcome::kFailed:
      return 1;
    case Outcome::kIncomplete:
      return 2;
    case Outcome::kError:
      break;
  }
  return 3;
}

int Badness(ExpectationOutcome outcome) {
  switch (outcome) {
    case ExpectationOutcome::kPassed:
      return 0;
    case ExpectationOutcome::kNotApplicable:
      return 1;
    case ExpectationOutcome::kFailed:
      break;
  }
  return 2;
}

/// @param expectation "" = the run as a whole
template <typename T>
void CompareOutcome(const RunSummary& run, const std::string& expectation, T before, T after,
                    SuiteComparison& comparison) {
  if (before == after) return;
  comparison.outcomes.push_back(
      {Title(run), expectation, ToString(before), ToString(after),
       Badness(after) > Badness(before) ? Verdict::kWorse : Verdict::kBetter});
}

void CompareOutcomes(const RunPair& pair, SuiteComparison& comparison) {
  const auto& [before, after] = pair;
  CompareOutcome(*after, "", before->outcome, after->outcome, comparison);
  for (const ExpectationResult& was : before->expectations) {
    const auto is = std::find_if(after->expectations.begin(), after->expectations.end(),
                                 [&was](const auto& e) { return e.name == was.name; });
    if (is == after->expectations.end()) {
      comparison.missing.push_back(fmt::format("{}: expectation '{}'", Title(*after), was.name));
      continue;
    }
    CompareOutcome(*after, was.name, was.outcome, is->outcome, comparison);
  }
}

void ListMissingMetrics(const RunPair& pair, SuiteComparison& comparison) {
  for (const auto& [metric, value] : pair.first->metrics) {
    if (pair.second->metrics.count(metric) > 0) continue;
    comparison.missing.push_back(fmt::format("{}: metric {}", Title(*pair.second), metric));
  }
}

/// One metric of the runs that both sides played, by pairs.
struct PairedValues {
  std::vector<std::uint64_t> seeds;
  std::vector<double> olds, news, worsenings;
};

PairedValues ValuesOf(const Metric& metric, const std::vector<RunPair>& pairs) {
  PairedValues values;
  for (const auto& [before, after] : pairs) {
    const auto was = before->metrics.find(metric.name);
    const auto is = after->metrics.find(metric.name);
    if (was == before->metrics.end() || is == after->metrics.end()) continue;
    values.seeds.push_back(before->seed);
    values.olds.push_back(was->second);
    values.news.push_back(is->second);
    values.worsenings.push_back(Worsening(metric, was->second, is->second));
  }
  return values;
}

/// No difference below this is told from none.
double Floor(const Metric& metric, const std::vector<double>& olds, double share) {
  return std::max(share * std::abs(MedianOf(olds)), SmallestStep(metric));
}

/// @pre there is a pair
SeedChange WorstPair(const Metric& metric, const PairedValues& values) {
  const auto worst = std::max_element(values.worsenings.begin(), values.worsenings.end());
  const auto i = static_cast<std::size_t>(worst - values.worsenings.begin());
  SeedChange change{values.seeds[i], values.olds[i], values.news[i], *worst};
  std::vector<double> others = values.worsenings;
  others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
  change.noise = std::max(PairNoise(others, values.olds), Floor(metric, values.olds, kFloorFew));
  change.verdict = Judge(change.worsening, change.noise);
  return change;
}

/// Nothing when no pair has the metric on both sides.
std::optional<MetricChange> CompareMetric(const Metric& metric, const std::vector<RunPair>& pairs) {
  const PairedValues values = ValuesOf(metric, pairs);
  if (values.olds.empty()) return std::nullopt;
  MetricChange change;
  change.metric = metric.name;
  change.unit = metric.unit;
  change.pairs = static_cast<int>(values.olds.size());
  change.before = MedianOf(values.olds);
  change.after = MedianOf(values.news);
  if (metric.whole) {
    // A count that rises in one run of many is a real event: judge the sum, not the median.
    for (double w : values.worsenings) change.worsening += w;
  } else {
    const bool few = values.olds.size() < kRunsForSpread;
    change.worsening = MedianOf(values.worsenings);
    change.noise = std::max(MedianNoise(values.worsenings),
                            Floor(metric, values.olds, few ? kFloorFew : kFloorMany));
  }
  change.worst = WorstPair(metric, values);
  change.verdict = change.worst.verdict == Verdict::kWorse ? Verdict::kWorse
                                                           : Judge(change.worsening, change.noise);
  return change;
}

std::optional<TimingChange> CompareStage(const std::string& stage,
                                         const std::vector<RunPair>& pairs) {
  std::vector<double> olds, news, logs;
  for (const auto& [before, after] : pairs) {
    const auto was = before->timing_ms.find(stage);
    const auto is = after->timing_ms.find(stage);
    if (was == before->timing_ms.end() || is == after->timing_ms.end()) continue;
    const double was_ms = was->second.median_ms.value_or(0);
    const double is_ms = is->second.median_ms.value_or(0);
    if (was_ms <= 0 || is_ms <= 0) continue;
    olds.push_back(was_ms);
    news.push_back(is_ms);
    logs.push_back(std::log(is_ms / was_ms));
  }
  if (olds.empty()) return std::nullopt;
  TimingChange change;
  change.stage = stage;
  change.pairs = static_cast<int>(olds.size());
  change.ratio = std::exp(MedianOf(logs));
  change.noise = std::max(kTimingFloor, std::expm1(MedianNoise(logs)));
  change.before_ms = MedianOf(std::move(olds));
  change.after_ms = MedianOf(std::move(news));
  const bool noticeable = std::abs(change.after_ms - change.before_ms) > kTimingFloor_ms;
  const double log_ratio = noticeable ? std::log(change.ratio) : 0;
  change.verdict = Judge(log_ratio, std::log1p(change.noise));
  if (!noticeable && change.ratio != 1) change.verdict = Verdict::kWithinNoise;
  return change;
}

void CompareGroup(const GroupKey& group, const std::vector<RunPair>& pairs,
                  SuiteComparison& comparison) {
  for (const Metric& metric : Metrics()) {
    auto change = CompareMetric(metric, pairs);
    if (!change) continue;
    std::tie(change->scenario, change->backend) = group;
    comparison.metrics.push_back(std::move(*change));
  }
  std::map<std::string, int> stages;
  for (const auto& [before, after] : pairs) {
    for (const auto& [stage, timing] : before->timing_ms) ++stages[stage];
  }
  for (const auto& [stage, count] : stages) {
    auto change = CompareStage(stage, pairs);
    if (!change) continue;
    std::tie(change->scenario, change->backend) = group;
    comparison.timings.push_back(std::move(*change));
  }
}

template <typename Changes>
bool AnyWorse(const Changes& changes) {
  return std::any_of(changes.begin(), changes.end(),
                     [](const auto& c) { return c.verdict == Verdict::kWorse; });
}

std::vector<std::string> BuildsOf(const std::vector<RunSummary>& runs) {
  std::set<std::string> builds;
  for (const RunSummary& run : runs) builds.insert(DescribeBuild(run.versions));
  return {builds.begin(), builds.end()};
}

}  // namespace

bool SuiteComparison::OutcomesOrMetricsRegressed() const {
  return AnyWorse(outcomes) || AnyWorse(metrics);
}

bool SuiteComparison::TimingsRegressed() const { return AnyWorse(timings); }

double Worsening(const Metric& metric, double before, double after) {
  switch (metric.better) {
    case Better::kLower:
      return after - before;
    case Better::kHigher:
      return before - after;
    case Better::kNearZero:
      return std::abs(after) - std::abs(before);
  }
  return 0;
}

SuiteComparison Compare(const std::vector<RunSummary>& before,
                        const std::vector<RunSummary>& after) {
  SuiteComparison comparison;
  comparison.builds_before = BuildsOf(before);
  comparison.builds_after = BuildsOf(after);
  const auto olds = ByKey(before);
  const auto news = ByKey(after);
  std::map<GroupKey, std::vector<RunPair>> groups;
  for (const auto& [key, run] : olds) {
    const auto match = news.find(key);
    if (match == news.end()) {
      comparison.missing.push_back(Title(*run));
      continue;
    }
    ++comparison.pairs;
    CompareOutcomes({run, match->second}, comparison);
    ListMissingMetrics({run, match->second}, comparison);
    groups[{run->scenario, run->backend}].emplace_back(run, match->second);
  }
  for (const auto& [key, run] : news) {
    if (olds.count(key) == 0) comparison.added.push_back(Title(*run));
  }
  for (const auto& [group, pairs] : groups) CompareGroup(group, pairs, comparison);
  return comparison;
}

}  // namespace horopter::scenarios
