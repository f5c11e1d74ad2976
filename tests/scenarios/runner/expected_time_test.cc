// SPDX-License-Identifier: Apache-2.0
#include "scenarios/runner/expected_time.h"

#include <gtest/gtest.h>

namespace horopter::scenarios {
namespace {

Scenario WithSteps(std::vector<StepAction> actions) {
  Scenario scenario;
  scenario.name = "a";
  for (const StepAction& action : actions) scenario.steps.push_back({{}, action});
  return scenario;
}

double GotoSeconds(double x_m, double timeout_s) {
  return ExpectedSimSeconds(WithSteps({GotoStep{{x_m, 0}, 0.1, timeout_s}}));
}

TEST(ExpectedSimSeconds, IsWhatStepsHoldAndALittleForTurning) {
  const double s = ExpectedSimSeconds(
      WithSteps({WaitStep{3}, FixateStep{{1, 0, 0.3}, 2}, SaccadeStep{20, 0, 0, 0.5}}));
  EXPECT_GT(s, 5.5);
  EXPECT_LT(s, 8);
}

TEST(ExpectedSimSeconds, GrowsWithTheWayAndNotWithTheTimeout) {
  EXPECT_DOUBLE_EQ(GotoSeconds(3, 80), GotoSeconds(3, 60));
  EXPECT_DOUBLE_EQ(GotoSeconds(2, 80), 2 * GotoSeconds(1, 80));
  EXPECT_GE(GotoSeconds(3, 80), 3 / Scenario().navigation.cruise_speed_m_s);
  EXPECT_EQ(GotoSeconds(3, 10), 10);
  const double there = GotoSeconds(1, 80);
  EXPECT_DOUBLE_EQ(ExpectedSimSeconds(WithSteps({GotoStep{{1, 0}}, GotoStep{{0, 0}}})), 2 * there);
}

TEST(ExpectedSimSeconds, NeverExceedsTheTimeLimit) {
  Scenario scenario = WithSteps({WaitStep{50}});
  scenario.time_limit_s = 20;
  EXPECT_EQ(ExpectedSimSeconds(scenario), 20);
}

TEST(ExpectedTimes, LearnFromTheRunsOfTheSameScenario) {
  const Scenario scenario = WithSteps({WaitStep{50}});
  ExpectedTimes times;
  RunSummary run;
  run.scenario = "another";
  run.sim_s = 3;
  times.Learn(run);
  EXPECT_EQ(times.Of(scenario), ExpectedSimSeconds(scenario));
  run.scenario = scenario.name;
  times.Learn(run);
  run.sim_s = 7;
  times.Learn(run);
  run.sim_s.reset();  // died
  times.Learn(run);
  EXPECT_EQ(times.Of(scenario), 5);
}

}  // namespace
}  // namespace horopter::scenarios
