// SPDX-License-Identifier: Apache-2.0
#include "scenarios/cli/compare.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "scenarios/cli/compare_table.h"
#include "scenarios/results/results_error.h"

namespace horopter::scenarios {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

RunSummary Played(std::uint64_t seed, std::map<std::string, double> metrics = {}) {
  RunSummary run;
  run.scenario = "first waypoint";
  run.backend = "sim";
  run.seed = seed;
  run.outcome = Outcome::kPassed;
  run.metrics = std::move(metrics);
  return run;
}

/// Ten seeds whose metric is `value` plus noise of the given deviation, from a generator of its
/// own.
std::vector<RunSummary> Runs(const std::string& metric, double value, double sigma,
                             unsigned stream) {
  std::mt19937 random(stream);
  std::normal_distribution<double> noise(0, 1);
  std::vector<RunSummary> runs;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    runs.push_back(Played(seed, {{metric, value + sigma * noise(random)}}));
  }
  return runs;
}

Verdict MetricVerdict(const std::vector<RunSummary>& before, const std::vector<RunSummary>& after) {
  const SuiteComparison comparison = Compare(before, after);
  EXPECT_EQ(comparison.metrics.size(), 1u);
  return comparison.metrics.empty() ? Verdict::kSame : comparison.metrics.front().verdict;
}

TEST(Compare, ASuiteAgainstItselfIsTheSame) {
  const auto runs = Runs("clearance", 0.1, 0.02, 1);
  const SuiteComparison comparison = Compare(runs, runs);
  EXPECT_EQ(comparison.pairs, 10);
  EXPECT_TRUE(comparison.outcomes.empty());
  EXPECT_EQ(comparison.metrics.front().verdict, Verdict::kSame);
  EXPECT_FALSE(comparison.OutcomesOrMetricsRegressed());
}

TEST(Compare, DirectionOfBetterComesFromTheRegistry) {
  const auto worse = [](const char* name, double before, double after) {
    return Worsening(*FindMetric(name), before, after) > 0;
  };
  EXPECT_TRUE(worse("clearance", 0.2, 0.1));
  EXPECT_FALSE(worse("clearance", 0.1, 0.2));
  EXPECT_TRUE(worse("depth.abs_rel.median", 0.1, 0.2));
  EXPECT_TRUE(worse("depth.bias", 0.1, -0.2));
  EXPECT_FALSE(worse("depth.bias", -0.2, 0.1));
}

TEST(Compare, NoiseOverSeedsIsNoRegressionAndAShiftBeyondItIs) {
  const auto before = Runs("depth.abs_rel.median", 0.03, 0.004, 1);
  EXPECT_EQ(MetricVerdict(before, Runs("depth.abs_rel.median", 0.03, 0.004, 2)),
            Verdict::kWithinNoise);
  EXPECT_EQ(MetricVerdict(before, Runs("depth.abs_rel.median", 0.05, 0.004, 2)), Verdict::kWorse);
  EXPECT_EQ(MetricVerdict(before, Runs("depth.abs_rel.median", 0.01, 0.004, 2)), Verdict::kBetter);
}

/// One metric of seeds 1, 2, ...
std::vector<RunSummary> Seeds(const std::string& metric, const std::vector<double>& values) {
  std::vector<RunSummary> runs;
  for (double value : values) runs.push_back(Played(runs.size() + 1, {{metric, value}}));
  return runs;
}

TEST(Compare, DisasterOnOneSeedIsARegressionThoughTheMedianStays) {
  const auto judge = [](const char* metric, std::vector<double> olds, std::size_t worst,
                        double value) {
    std::vector<double> news = olds;
    news[worst] = value;
    return Compare(Seeds(metric, olds), Seeds(metric, news));
  };
  const SuiteComparison clearance = judge("clearance", {0.20, 0.26, 0.31, 0.324, 0.29}, 3, 0.051);
  EXPECT_TRUE(clearance.OutcomesOrMetricsRegressed());
  ASSERT_EQ(clearance.metrics.size(), 1u);
  const MetricChange& change = clearance.metrics[0];
  EXPECT_EQ(change.worsening, 0);
  EXPECT_EQ(change.worst.seed, 4u);
  EXPECT_EQ(change.worst.before, 0.324);
  EXPECT_EQ(change.worst.after, 0.051);
  EXPECT_NEAR(change.worst.worsening, 0.273, 1e-12);
  EXPECT_EQ(change.worst.verdict, Verdict::kWorse);
  EXPECT_THAT(CompareTable(clearance, false),
              HasSubstr("seed 4: 0.324 -> 0.051, WORSE by 0.273, noise 0."));
  EXPECT_TRUE(judge("time_to_goal", {20, 31, 25, 42, 36}, 0, 79).OutcomesOrMetricsRegressed());
  EXPECT_FALSE(
      judge("clearance", {0.20, 0.26, 0.31, 0.324, 0.29}, 3, 0.25).OutcomesOrMetricsRegressed())
      << "within what seeds differ by";
}

TEST(Compare, WorstSeedIsJudgedAlsoWhereAllOthersImproved) {
  const auto before = Seeds("clearance", {0.20, 0.20, 0.20, 0.20, 0.20});
  const auto after = Seeds("clearance", {0.25, 0.25, 0.25, 0.25, 0.10});
  EXPECT_EQ(MetricVerdict(before, after), Verdict::kWorse);
}

TEST(Compare, ContactOfOneSeedIsNotMadeUpForByAnother) {
  EXPECT_EQ(MetricVerdict(Seeds("contacts", {0, 0, 0, 1, 0}), Seeds("contacts", {1, 0, 0, 0, 0})),
            Verdict::kWorse);
}

TEST(Compare, PureNoiseSeldomHasASeedThatIsWorse) {
  constexpr int kSuites = 200;
  int alarms = 0;
  for (unsigned i = 0; i < kSuites; ++i) {
    const auto change =
        Compare(Runs("path_length", 4, 0.5, 2 * i), Runs("path_length", 4, 0.5, 2 * i + 1));
    alarms += change.metrics.at(0).worst.verdict == Verdict::kWorse ? 1 : 0;
  }
  EXPECT_LE(alarms, 0.04 * kSuites);
}

TEST(Compare, SingleRunsGetACoarseLimit) {
  const auto one = [](double value) {
    return std::vector<RunSummary>{Played(1, {{"clearance", value}})};
  };
  EXPECT_EQ(MetricVerdict(one(0.10), one(0.095)), Verdict::kWithinNoise);
  EXPECT_EQ(MetricVerdict(one(0.10), one(0.080)), Verdict::kWorse);
}

TEST(Compare, EveryMoreContactIsWorse) {
  auto after = Runs("contacts", 0, 0, 1);
  const auto before = after;
  after[7].metrics["contacts"] = 1;
  EXPECT_EQ(MetricVerdict(before, after), Verdict::kWorse);
  EXPECT_EQ(MetricVerdict(after, before), Verdict::kBetter);
}

TEST(Compare, PassedToAnythingElseIsARegression) {
  for (Outcome ended : {Outcome::kFailed, Outcome::kError, Outcome::kIncomplete}) {
    RunSummary after = Played(1);
    after.outcome = ended;
    EXPECT_TRUE(Compare({Played(1)}, {after}).OutcomesOrMetricsRegressed());
    EXPECT_FALSE(Compare({after}, {Played(1)}).OutcomesOrMetricsRegressed());
  }
}

TEST(Compare, EveryStepDownIsARegressionAndEveryStepUpNone) {
  const Outcome ranked[] = {Outcome::kPassed, Outcome::kFailed, Outcome::kIncomplete,
                            Outcome::kError};
  for (int better = 0; better < 4; ++better) {
    for (int worse = better + 1; worse < 4; ++worse) {
      RunSummary before = Played(1), after = Played(1);
      before.outcome = ranked[better];
      after.outcome = ranked[worse];
      EXPECT_TRUE(Compare({before}, {after}).OutcomesOrMetricsRegressed()) << better << worse;
      EXPECT_FALSE(Compare({after}, {before}).OutcomesOrMetricsRegressed()) << better << worse;
    }
  }
}

TEST(Compare, ExpectationThatNoLongerAppliesOrNowFailsIsARegression) {
  const auto ended = [](ExpectationOutcome outcome) {
    RunSummary run = Played(1);
    run.expectations.emplace_back().name = "contacts 0";
    run.expectations.back().outcome = outcome;
    return std::vector<RunSummary>{run};
  };
  const auto passed = ended(ExpectationOutcome::kPassed);
  const auto unjudged = ended(ExpectationOutcome::kNotApplicable);
  const auto failed = ended(ExpectationOutcome::kFailed);
  EXPECT_TRUE(Compare(passed, unjudged).OutcomesOrMetricsRegressed());
  EXPECT_TRUE(Compare(unjudged, failed).OutcomesOrMetricsRegressed());
  EXPECT_FALSE(Compare(failed, unjudged).OutcomesOrMetricsRegressed());
}

TEST(Compare, ExpectationsAreComparedWithinFailedRuns) {
  RunSummary before = Played(1);
  before.outcome = Outcome::kFailed;
  ExpectationResult expectation;
  expectation.name = "contacts 0";
  expectation.outcome = ExpectationOutcome::kPassed;
  before.expectations = {expectation};
  RunSummary after = before;
  after.expectations[0].outcome = ExpectationOutcome::kFailed;
  const SuiteComparison comparison = Compare({before}, {after});
  ASSERT_EQ(comparison.outcomes.size(), 1u);
  EXPECT_EQ(comparison.outcomes[0].expectation, "contacts 0");
  EXPECT_TRUE(comparison.OutcomesOrMetricsRegressed());
}

TEST(Compare, RunsAreMatchedBySeedAndMissingOnesNamed) {
  const SuiteComparison comparison = Compare({Played(1), Played(2)}, {Played(3), Played(2)});
  EXPECT_EQ(comparison.pairs, 1);
  EXPECT_THAT(comparison.missing, ElementsAre("first waypoint, seed 1, sim"));
  EXPECT_THAT(comparison.added, ElementsAre("first waypoint, seed 3, sim"));
}

TEST(Compare, MissingExpectationsAndMetricsAreNamed) {
  RunSummary before = Played(1, {{"clearance", 0.2}, {"contacts", 0}});
  before.expectations.emplace_back().name = "contacts 0";
  const SuiteComparison lost = Compare({before}, {Played(1, {{"contacts", 0}})});
  EXPECT_THAT(lost.missing, ElementsAre("first waypoint, seed 1, sim: expectation 'contacts 0'",
                                        "first waypoint, seed 1, sim: metric clearance"));
  EXPECT_THAT(CompareTable(lost, false), HasSubstr("metric clearance"));
  EXPECT_TRUE(Compare({Played(1)}, {before}).missing.empty());  // more than before is no loss
}

TEST(Compare, RunsThatShareTheirNameAreRefused) {
  RunSummary one = Played(1), other = Played(1);
  one.directory = "koala-a-seed1";
  other.directory = "lab-a-seed1";
  for (const bool old_side : {true, false}) {
    const std::vector<RunSummary> twice = {one, other}, once = {one};
    try {
      Compare(old_side ? twice : once, old_side ? once : twice);
      FAIL();
    } catch (const ResultsError& error) {
      EXPECT_THAT(error.what(), HasSubstr("first waypoint, seed 1, sim"));
      EXPECT_THAT(error.what(), HasSubstr("koala-a-seed1 and lab-a-seed1"));
    }
  }
}

TEST(Compare, StagesThatNeverRanAreNotCompared) {
  RunSummary idle = Played(1), busy = Played(1);
  idle.timing_ms["disparity"] = {};
  busy.timing_ms["disparity"] = {100, 120, 10};
  EXPECT_TRUE(Compare({idle}, {busy}).timings.empty());
  EXPECT_TRUE(Compare({busy}, {idle}).timings.empty());
}

TEST(Compare, TimingsRegressOnlyBeyondAGenerousRatio) {
  const auto timed = [](double ms) {
    RunSummary run = Played(1);
    run.timing_ms["disparity"] = {ms, ms, 10};
    return std::vector<RunSummary>{run};
  };
  EXPECT_FALSE(Compare(timed(100), timed(115)).TimingsRegressed());
  EXPECT_TRUE(Compare(timed(100), timed(150)).TimingsRegressed());
  EXPECT_FALSE(Compare(timed(100), timed(150)).OutcomesOrMetricsRegressed());
  EXPECT_FALSE(Compare(timed(0.01), timed(0.1)).TimingsRegressed());  // below what is noticeable
}

TEST(CompareTable, NamesTheBuildsOfBothSides) {
  RunSummary before = Played(1), after = Played(1), other = Played(2);
  before.versions = {{"horopter", "0.1.0 (abc1234)"}, {"program", "111"}};
  after.versions = {{"horopter", "0.1.0 (def5678-dirty)"}, {"program", "222"}};
  const std::string table = CompareTable(Compare({before}, {after, other}), false);
  EXPECT_THAT(table, HasSubstr("old: horopter 0.1.0 (abc1234), program 111\n"));
  EXPECT_THAT(table,
              HasSubstr("new: horopter 0.1.0 (def5678-dirty), program 222 and an unknown build\n"));
}

TEST(CompareTable, ShowsRegressionsFirstAndCountsTheRest) {
  auto before = Played(1, {{"clearance", 0.2}, {"path_length", 3.0}, {"contacts", 0}});
  auto after = Played(1, {{"clearance", 0.1}, {"path_length", 2.0}, {"contacts", 0}});
  const std::string table = CompareTable(Compare({before}, {after}), false);
  EXPECT_THAT(table, HasSubstr("WORSE"));
  EXPECT_LT(table.find("clearance"), table.find("path_length"));
  EXPECT_THAT(table, HasSubstr("1 metrics the same"));
  EXPECT_EQ(table.find("contacts"), std::string::npos);
  EXPECT_THAT(CompareTable(Compare({before}, {after}), true), HasSubstr("contacts"));
}

}  // namespace
}  // namespace horopter::scenarios
