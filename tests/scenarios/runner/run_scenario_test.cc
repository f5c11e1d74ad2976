// SPDX-License-Identifier: Apache-2.0
#include "scenarios/runner/run_scenario.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <opencv2/core/utility.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "scenarios/format/scenario_format.h"
#include "scenarios/format/scenes.h"
#include "scenarios/results/results_error.h"
#include "scenarios/results/suite.h"
#include "scenarios/runner/run_process.h"

namespace horopter::scenarios {
namespace {

namespace fs = std::filesystem;

/// Looks at the board, drives half a second: every stage of the stack at work.
constexpr const char* kShort = R"(
scene: koala/chessboard_room.xml
time_limit_s: 10
camera: {width: 160, height: 120}
vision: {scales: 4, rate_hz: 4, latency_s: 0.2}
steps:
  - fixate: {x_m: 1.05, y_m: 0.0, z_m: 0.30, hold_s: 0.3}
  - goto: {x_m: 0.25, y_m: 0.0, timeout_s: 6}
expect:
  - contacts 0
  - fixation.error_deg.p95 <= 1 deg
)";

Scenario Short(std::uint64_t seed = 1) {
  Scenario scenario = ParseScenarioText(kShort, "short.yaml", {ScenesDir()});
  scenario.seed = seed;
  return scenario;
}

class RunScenarioTest : public testing::Test {
 protected:
  fs::path Folder(const std::string& name) const {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    return fs::path(testing::TempDir()) / "horopter_run_scenario" / info->name() / name;
  }

  /// In a process of its own, so that the environment of each run is its own as well.
  FinishedRun Finished(const Scenario& scenario, const std::string& name) const {
    RunProcess process(scenario, Folder(name), std::nullopt);
    while (process.Poll()) {
    }
    return process.Finish();
  }
  RunSummary Play(const Scenario& scenario, const std::string& name) const {
    return Finished(scenario, name).summary;
  }
};

/// Everything that must not depend on when and on what the run was made.
RunSummary WithoutWallClock(RunSummary summary) {
  summary.wall_s.reset();
  summary.machine = {};
  summary.timing_ms.clear();
  summary.directory.clear();
  return summary;
}

/// The cells of the next line of a CSV file; none at its end.
std::vector<std::string> Cells(std::istream& in) {
  std::string line;
  if (!std::getline(in, line)) return {};
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') quoted = !quoted;
    if (c == ',' && !quoted) {
      cells.emplace_back();
    } else {
      cells.back() += c;
    }
  }
  return cells;
}

std::string SuiteText(const fs::path& folder, const RunSummary& summary) {
  WriteSuite(folder, {WithoutWallClock(summary)});
  std::ifstream in(folder / "summary.json");
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

TEST_F(RunScenarioTest, SameSeedGivesTheSameImagesDecisionsAndSummary) {
  const RunSummary first = Play(Short(), "first");
  const RunSummary second = Play(Short(), "second");
  setenv("LP_NUM_THREADS", "0", 1);
  const RunSummary single = Play(Short(), "single");
  unsetenv("LP_NUM_THREADS");

  EXPECT_EQ(first.outcome, Outcome::kPassed) << first.error;
  EXPECT_EQ(first.image_hash.size(), 64u);
  for (const RunSummary* other : {&second, &single}) {
    EXPECT_EQ(first.image_hash, other->image_hash);
    EXPECT_EQ(first.decision_hash, other->decision_hash);
    EXPECT_EQ(SuiteText(Folder("a"), first), SuiteText(Folder("b"), *other));
  }
}

TEST_F(RunScenarioTest, AvoidingAnObstacleIsTheSameOnOneThread) {
  Scenario scenario = ParseScenario(
      fs::path(HOROPTER_SOURCE_DIR) / "scenarios/koala/first_waypoint.yaml", {ScenesDir()});
  scenario.time_limit_s = 5;
  const RunSummary threaded = Play(scenario, "threaded");
  setenv("LP_NUM_THREADS", "0", 1);
  cv::setNumThreads(1);
  const RunSummary single = Play(scenario, "single");
  cv::setNumThreads(-1);
  unsetenv("LP_NUM_THREADS");

  std::ostringstream frames;
  frames << std::ifstream(Folder("threaded") / "frames.csv").rdbuf();
  EXPECT_THAT(frames.str(), testing::HasSubstr("avoiding"));
  EXPECT_EQ(threaded.image_hash, single.image_hash);
  EXPECT_EQ(threaded.decision_hash, single.decision_hash);
  EXPECT_EQ(threaded.metrics, single.metrics);
}

TEST_F(RunScenarioTest, EncoderWithoutStepsStillSettles) {
  Scenario scenario = Short();
  scenario.head.encoder_step_deg = 0;
  EXPECT_EQ(Play(scenario, "run").outcome, Outcome::kPassed);
}

TEST_F(RunScenarioTest, SlowVisionStillDrives) {
  Scenario scenario = Short();
  scenario.vision.latency_s = 1.2;
  scenario.time_limit_s = 20;
  EXPECT_EQ(Play(scenario, "run").outcome, Outcome::kPassed);
}

TEST_F(RunScenarioTest, AnotherSeedGivesOtherImages) {
  EXPECT_NE(Play(Short(1), "one").image_hash, Play(Short(2), "two").image_hash);
}

TEST_F(RunScenarioTest, RunLeavesWhatTheDesignLists) {
  Play(Short(), "run");
  for (const char* file : {"scenario.yaml", "summary.json", "junit.xml", "report.html",
                           "frames.csv", "trajectory.csv", "frames/0000_left.png"}) {
    EXPECT_TRUE(fs::exists(Folder("run") / file)) << file;
  }
}

TEST_F(RunScenarioTest, ResolvedScenarioPlaysTheSameRun) {
  const RunSummary first = Play(Short(3), "first");
  const Scenario resolved = ParseScenario(Folder("first") / "scenario.yaml", {ScenesDir()});
  EXPECT_EQ(Play(resolved, "again").decision_hash, first.decision_hash);
}

TEST_F(RunScenarioTest, StagesAreTimed) {
  const RunSummary run = Play(Short(), "run");
  for (const char* stage : {"physics", "render", "read_back", "sensor", "disparity",
                            "reconstruction", "segmentation", "regions", "navigation, a tick"}) {
    ASSERT_EQ(run.timing_ms.count(stage), 1u) << stage;
    EXPECT_GT(run.timing_ms.at(stage).n, 0) << stage;
  }
  const StageTiming& cycle = run.timing_ms.at("vision, a cycle");
  EXPECT_EQ(cycle.modelled_ms, 200);
  EXPECT_EQ(cycle.n, run.timing_ms.at("disparity").n);
  EXPECT_GE(cycle.p95_ms, run.timing_ms.at("disparity").median_ms);
}

TEST_F(RunScenarioTest, TargetThatADriveLeavesBehindIsAnErrorOfItsStep) {
  std::string text = kShort;
  text.replace(text.find("expect:"), 0, "  - fixate: {x_m: 0.12, y_m: 0.0, z_m: 0.30}\n");
  const FinishedRun run = Finished(ParseScenarioText(text, "short.yaml", {ScenesDir()}), "run");
  EXPECT_EQ(run.exit_code, ExitCode::kBadInput);
  EXPECT_EQ(run.summary.outcome, Outcome::kError);
  EXPECT_THAT(run.summary.error,
              testing::StartsWith("short.yaml:9:5: fixate: cannot fixate: target (-"));
  EXPECT_THAT(run.summary.error, testing::HasSubstr("is behind the eyes"));
  EXPECT_EQ(run.summary.error.find('\n'), std::string::npos);
}

TEST_F(RunScenarioTest, FramesTakenWhileFixatingHaveTheirError) {
  Play(Short(), "run");
  std::ifstream in(Folder("run") / "frames.csv");
  const std::vector<std::string> header = Cells(in);
  const auto column = [&header](const char* name) {
    return std::find(header.begin(), header.end(), name) - header.begin();
  };
  const auto error = column("fixation_error_deg");
  int fixated = 0, others = 0;
  for (auto row = Cells(in); !row.empty(); row = Cells(in)) {
    ASSERT_EQ(row.size(), header.size());
    ++(row[error].empty() ? others : fixated);
    if (row[error].empty()) continue;
    EXPECT_LT(std::stod(row[error]), 1);
  }
  EXPECT_GE(fixated, 1);
  EXPECT_GE(others, 1);  // while driving
  std::ostringstream report;
  report << std::ifstream(Folder("run") / "report.html").rdbuf();
  EXPECT_THAT(report.str(), testing::HasSubstr("Fixation error"));
}

TEST_F(RunScenarioTest, GotoThatIsNeverBegunIsNotReached) {
  Scenario scenario = ParseScenarioText(
      std::string(kShort) + "  - reached within 0.2 m before 9 s\n", "short.yaml", {ScenesDir()});
  scenario.steps = {scenario.steps[1], scenario.steps[0], scenario.steps[1]};
  GotoStep hurried;
  hurried.goal_m = {0.5, 0};
  hurried.timeout_s = 0.1;
  scenario.steps[1].action = hurried;
  const RunSummary run = Play(scenario, "run");
  ASSERT_FALSE(run.expectations.empty());
  EXPECT_EQ(run.expectations.back().outcome, ExpectationOutcome::kFailed);
  EXPECT_THAT(run.expectations.back().detail, testing::HasSubstr("never begun"));
  EXPECT_EQ(run.metrics.count("reached"), 0u);
}

TEST_F(RunScenarioTest, StepThatEndsAtTheTimeLimitHasEnded) {
  Scenario scenario = Short();
  scenario.steps.resize(1);
  scenario.steps[0].action = WaitStep{1};
  scenario.expect.resize(1);
  scenario.time_limit_s = 1;
  EXPECT_EQ(Play(scenario, "run").outcome, Outcome::kPassed);
}

TEST_F(RunScenarioTest, StepAfterTheTimeLimitIsNotBegun) {
  Scenario scenario = Short();
  scenario.steps[0].action = WaitStep{1};
  scenario.time_limit_s = 1;
  const RunSummary run = Play(scenario, "run");
  EXPECT_EQ(run.outcome, Outcome::kFailed);
  EXPECT_THAT(run.error, testing::HasSubstr("before goto"));
  EXPECT_EQ(run.metrics.count("reached"), 0u);
}

TEST_F(RunScenarioTest, TimeLimitEndsTheRun) {
  Scenario scenario = Short();
  scenario.time_limit_s = 1;
  scenario.steps[0].action = WaitStep{5};
  const RunSummary run = Play(scenario, "run");
  EXPECT_EQ(run.outcome, Outcome::kFailed);
  EXPECT_NEAR(run.sim_s.value(), 1, 0.05);
  EXPECT_THAT(run.error, testing::HasSubstr("time limit"));
}

TEST_F(RunScenarioTest, InterruptedRunIsIncompleteAndReadable) {
  // In a process of its own: once this one has rendered, OSMesa's threads forbid it to fork runs.
  const pid_t child = fork();
  if (child == 0) {
    RunHooks hooks;
    int ticks = 0;
    hooks.interrupted = [&ticks] { return ++ticks > 20; };
    _exit(static_cast<int>(RunScenario(Short(), Folder("run"), hooks).exit_code));
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), static_cast<int>(ExitCode::kInfrastructure));
  EXPECT_EQ(ReadSuiteSummary(Folder("run")).at(0).outcome, Outcome::kIncomplete);
}

TEST_F(RunScenarioTest, MissingSceneIsBadInput) {
  Scenario scenario = Short();
  scenario.scene = "koala/no_such_room.xml";
  const FinishedRun run = RunScenario(scenario, Folder("run"), {});
  EXPECT_EQ(run.summary.outcome, Outcome::kError);
  EXPECT_EQ(run.exit_code, ExitCode::kBadInput);
  EXPECT_THAT(run.summary.error, testing::HasSubstr("no_such_room.xml"));
}

TEST_F(RunScenarioTest, SceneWithAShapeThatTheOracleLacksIsBadInput) {
  Scenario scenario = Short();
  scenario.scene = HOROPTER_SOURCE_DIR "/tests/scenarios/runner/data/hills.xml";
  scenario.variation = {0, 0, false};
  const FinishedRun run = Finished(scenario, "run");
  EXPECT_EQ(run.exit_code, ExitCode::kBadInput);
  EXPECT_THAT(run.summary.error, testing::HasSubstr("hills.xml"));
  EXPECT_THAT(run.summary.error, testing::HasSubstr("height field"));
}

TEST_F(RunScenarioTest, FolderThatCannotBeWrittenThrows) {
  const fs::path file = Folder("file");
  fs::create_directories(file.parent_path());
  std::ofstream(file) << "not a folder";
  EXPECT_THROW(RunScenario(Short(), file / "run", {}), ResultsError);
}

}  // namespace
}  // namespace horopter::scenarios
