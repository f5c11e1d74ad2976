// SPDX-License-Identifier: Apache-2.0
#include "scenarios/runner/progress.h"

#include <gtest/gtest.h>

namespace horopter::scenarios {
namespace {

RunSummary Ended(double sim_s) {
  RunSummary run;
  run.sim_s = sim_s;
  return run;
}

TEST(Progress, TimeLeftFollowsThePaceSoFar) {
  EXPECT_EQ(TimeLeft(10, 0.5, 100), "");  // no pace yet
  EXPECT_EQ(TimeLeft(10, 5, 20), "about 30 s left");
  EXPECT_EQ(TimeLeft(10, 10, 130), "about 2 min 0 s left");
  EXPECT_EQ(TimeLeft(1, 2, 241), "about 2 min 0 s left");  // 119.5 s, never "1 min 60 s"
}

TEST(Progress, KeptRunsCountAsRunsAndNotAsWork) {
  Progress::State state;
  state.AddKept();
  state.AddWaiting(90);
  EXPECT_EQ(state.runs, 2);
  EXPECT_EQ(state.done_runs, 1);
  EXPECT_EQ(state.done_sim_s, 0);
  EXPECT_EQ(state.total_sim_s, 90);
}

TEST(Progress, EndedRunsCountWithWhatTheyTook) {
  Progress::State state;
  state.AddEnded(Ended(30));
  state.AddEnded(RunSummary());  // died without a summary
  state.AddUnderWay(15, 90, "goto");
  EXPECT_EQ(state.runs, 3);
  EXPECT_EQ(state.done_runs, 2);
  EXPECT_EQ(state.done_sim_s, 45);
  EXPECT_EQ(state.total_sim_s, 120);
}

TEST(Progress, OverdueRunsAreNeverDone) {
  Progress::State state;
  state.AddUnderWay(40, 30, "goto");
  EXPECT_GT(state.total_sim_s, 40);
  EXPECT_LT(state.total_sim_s, 60);
}

}  // namespace
}  // namespace horopter::scenarios
