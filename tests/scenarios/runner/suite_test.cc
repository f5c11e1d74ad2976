// SPDX-License-Identifier: Apache-2.0
#include "scenarios/runner/suite.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

#include "scenarios/format/scenario_format.h"
#include "scenarios/format/scenes.h"
#include "scenarios/results/files.h"
#include "scenarios/results/suite.h"
#include "scenarios/results/summary_json.h"
#include "scenarios/runner/run_process.h"
#include "scenarios/runner/versions.h"

namespace horopter::scenarios {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

std::string Turning(const std::string& expectation, double hold_s = 0.2) {
  std::ostringstream text;
  text << "scene: koala/chessboard_room.xml\n"
          "tags: [quick]\n"
          "time_limit_s: 600\n"
          "camera: {width: 80, height: 60}\n"
          "vision: {scales: 2, rate_hz: 1}\n"
          "steps:\n"
          "  - saccade: {pan_deg: 5, tilt_deg: 0, vergence_deg: 1, hold_s: "
       << hold_s << "}\nexpect:\n  - " << expectation << "\n";
  return text.str();
}

SuiteOptions Options(const fs::path& input) {
  SuiteOptions options;
  options.inputs = {input};
  return options;
}

class SuiteTest : public testing::Test {
 protected:
  SuiteTest() {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    root_ = fs::path(testing::TempDir()) / "horopter_suite" / info->name();
    fs::remove_all(root_);
    fs::create_directories(root_);
  }

  fs::path Write(const std::string& name, const std::string& text) const {
    std::ofstream(root_ / name) << text;
    return root_ / name;
  }

  ExitCode Run(SuiteOptions options) {
    if (options.out.empty()) options.out = root_ / "out";
    out_.str("");
    err_.str("");
    return RunSuite(options, out_, err_);
  }

  fs::path root_;
  std::ostringstream out_;
  std::ostringstream err_;
};

TEST_F(SuiteTest, PassingSuiteExitsWithZeroAndPrintsTableAndReport) {
  EXPECT_EQ(Run(Options(Write("pass.yaml", Turning("contacts 0")))), ExitCode::kPassed)
      << err_.str();
  EXPECT_THAT(out_.str(), HasSubstr("contacts 0"));
  EXPECT_THAT(out_.str(), HasSubstr("pass"));
  EXPECT_THAT(out_.str(), HasSubstr("report.html"));
  const auto runs = ReadSuiteSummary(root_ / "out");
  ASSERT_EQ(runs.size(), 1u);
  EXPECT_EQ(runs[0].outcome, Outcome::kPassed);
}

TEST_F(SuiteTest, FailedExpectationExitsWithOne) {
  EXPECT_EQ(Run(Options(Write("fail.yaml", Turning("path_length >= 1 m")))),
            ExitCode::kExpectationFailed);
  EXPECT_THAT(out_.str(), HasSubstr("FAIL"));
}

TEST_F(SuiteTest, EveryScenarioIsPlayedWithEverySeedAlsoBesideEachOther) {
  Write("a.yaml", Turning("contacts 0"));
  Write("b.yaml", Turning("contacts 0"));
  SuiteOptions options = Options(root_);
  options.seeds = {4, 5};
  options.jobs = 2;
  EXPECT_EQ(Run(options), ExitCode::kPassed) << err_.str();
  const auto runs = ReadSuiteSummary(root_ / "out");
  ASSERT_EQ(runs.size(), 4u);
  EXPECT_EQ(runs[0].seed, 4u);
  EXPECT_NE(runs[0].image_hash, runs[1].image_hash);
  // The same room and seed under another name: beside each other or not, the same bits.
  EXPECT_EQ(runs[0].image_hash, runs[2].image_hash);
}

TEST_F(SuiteTest, BadInputExitsWithTwoBeforeAnythingRuns) {
  Write("good.yaml", Turning("contacts 0"));
  Write("bad.yaml", Turning("contacts 0") + "sede: 3\n");
  EXPECT_EQ(Run(Options(root_)), ExitCode::kBadInput);
  EXPECT_THAT(err_.str(), HasSubstr("bad.yaml:"));
  EXPECT_THAT(err_.str(), HasSubstr("seed"));
  EXPECT_FALSE(fs::exists(root_ / "out"));
}

TEST_F(SuiteTest, ScenariosThatWouldShareAResultsFolderAreBadInput) {
  for (const char* folder : {"x/koala", "y/koala"}) fs::create_directories(root_ / folder);
  const fs::path first = Write("x/koala/room.yaml", Turning("contacts 0"));
  const fs::path second = Write("y/koala/room.yaml", Turning("contacts 1"));
  EXPECT_EQ(Run(Options(root_)), ExitCode::kBadInput);
  EXPECT_THAT(err_.str(), HasSubstr(first.string()));
  EXPECT_THAT(err_.str(), HasSubstr(second.string()));
  EXPECT_FALSE(fs::exists(root_ / "out"));
}

TEST_F(SuiteTest, TagThatNoScenarioHasIsBadInput) {
  SuiteOptions options = Options(Write("a.yaml", Turning("contacts 0")));
  options.tags = {"slow"};
  EXPECT_EQ(Run(options), ExitCode::kBadInput);
}

TEST_F(SuiteTest, ResultsFolderThatCannotBeMadeExitsWithThree) {
  SuiteOptions options = Options(Write("a.yaml", Turning("contacts 0")));
  options.out = Write("file", "") / "out";
  EXPECT_EQ(Run(options), ExitCode::kInfrastructure);
  EXPECT_THAT(err_.str(), HasSubstr("--out"));
}

TEST_F(SuiteTest, ResultsFolderThatAnotherSuiteUsesIsRefused) {
  fs::create_directories(root_ / "out");
  const int other = open((root_ / "out").c_str(), O_RDONLY | O_DIRECTORY);
  ASSERT_EQ(flock(other, LOCK_EX | LOCK_NB), 0);
  EXPECT_EQ(Run(Options(Write("a.yaml", Turning("contacts 0")))), ExitCode::kInfrastructure);
  EXPECT_THAT(err_.str(), HasSubstr("--out"));
  EXPECT_TRUE(fs::is_empty(root_ / "out"));
  close(other);
}

TEST_F(SuiteTest, VisionThatIsSlowerThanModelledIsToldAndJudgesNothing) {
  std::string text = Turning("contacts 0");
  text.replace(text.find("rate_hz: 1"), 10, "rate_hz: 1, latency_s: 1.0e-6");
  EXPECT_EQ(Run(Options(Write("a.yaml", text))), ExitCode::kPassed);
  EXPECT_THAT(out_.str(), HasSubstr("notice: a seed 1: 'vision, a cycle' took"));
  EXPECT_THAT(out_.str(), HasSubstr("latency_s"));
}

TEST_F(SuiteTest, BackendThatIsNotThereExitsWithFour) {
  SuiteOptions options = Options(Write("a.yaml", Turning("contacts 0")));
  options.backend = "hardware";
  EXPECT_EQ(Run(options), ExitCode::kHardwareUnavailable);
}

TEST_F(SuiteTest, ResumeKeepsRunsThatEndedAndPlaysTheOthers) {
  SuiteOptions options = Options(Write("a.yaml", Turning("contacts 0")));
  options.seeds = {1};
  ASSERT_EQ(Run(options), ExitCode::kPassed);
  const auto kept = ReadSuiteSummary(root_ / "out").at(0);
  options.seeds = {1, 2};
  options.earlier = EarlierResults::kResume;
  ASSERT_EQ(Run(options), ExitCode::kPassed);
  const auto runs = ReadSuiteSummary(root_ / "out");
  ASSERT_EQ(runs.size(), 2u);
  EXPECT_EQ(runs[0].wall_s, kept.wall_s);  // not played again
  EXPECT_THAT(err_.str(), testing::Not(HasSubstr("seed 1:")));
  EXPECT_THAT(err_.str(), HasSubstr("seed 2:"));
}

TEST_F(SuiteTest, ResumePlaysAgainWhatHasChanged) {
  SuiteOptions options = Options(Write("a.yaml", Turning("contacts 0")));
  ASSERT_EQ(Run(options), ExitCode::kPassed);
  Write("a.yaml", Turning("contacts 0", 0.4));
  options.earlier = EarlierResults::kResume;
  ASSERT_EQ(Run(options), ExitCode::kPassed);
  EXPECT_THAT(err_.str(), HasSubstr("seed 1: passed"));
}

/// Makes the results in `out` those of another build.
void PretendAnotherBuild(const fs::path& run_folder) {
  RunSummary run = ReadSuiteSummary(run_folder).at(0);
  run.versions["horopter"] = "0.0.9 (abc1234)";
  run.versions["program"] = "0123456789ab";
  std::ofstream(run_folder / "summary.json") << RunSummaryText(run);
}

TEST_F(SuiteTest, ResumePlaysAgainWhatAnotherBuildMadeAndSaysSo) {
  SuiteOptions options = Options(Write("a.yaml", Turning("contacts 0")));
  options.seeds = {1, 2};
  ASSERT_EQ(Run(options), ExitCode::kPassed);
  PretendAnotherBuild(root_ / "out" / ReadSuiteSummary(root_ / "out").at(0).directory);
  options.earlier = EarlierResults::kResume;
  ASSERT_EQ(Run(options), ExitCode::kPassed);
  EXPECT_THAT(err_.str(), HasSubstr("1 ended run is played again"));
  EXPECT_THAT(err_.str(), HasSubstr("0.0.9 (abc1234), program 0123456789ab, this is " + Version()));
  EXPECT_THAT(err_.str(), HasSubstr("seed 1: passed"));
  EXPECT_THAT(err_.str(), testing::Not(HasSubstr("seed 2:")));
  EXPECT_EQ(ReadSuiteSummary(root_ / "out").at(0).versions, LibraryVersions());
}

TEST_F(SuiteTest, EarlierResultsAreLeftAloneUnlessTheyAreToBeResumedOrReplaced) {
  SuiteOptions options = Options(Write("a.yaml", Turning("contacts 0")));
  options.seeds = {1};
  ASSERT_EQ(Run(options), ExitCode::kPassed);
  const auto earlier = ReadSuiteSummary(root_ / "out");
  options.seeds = {3};
  EXPECT_EQ(Run(options), ExitCode::kBadInput);
  const std::string refusal = err_.str();
  EXPECT_THAT(refusal, HasSubstr((root_ / "out").string()));
  EXPECT_THAT(refusal, testing::AllOf(HasSubstr("--resume"), HasSubstr("--overwrite")));
  EXPECT_EQ(std::count(refusal.begin(), refusal.end(), '\n'), 1) << refusal;

  options.earlier = EarlierResults::kResume;  // would leave seed 1 behind, in no summary
  EXPECT_EQ(Run(options), ExitCode::kBadInput);
  EXPECT_THAT(err_.str(), testing::AllOf(HasSubstr("seed 1"), HasSubstr("--overwrite")));
  ASSERT_EQ(ReadSuiteSummary(root_ / "out").size(), 1u);
  EXPECT_EQ(ReadSuiteSummary(root_ / "out")[0].wall_s, earlier[0].wall_s);
  EXPECT_TRUE(fs::exists(root_ / "out" / earlier[0].directory / "report.html"));
}

TEST_F(SuiteTest, OverwritingRemovesTheEarlierRunsAndNothingElse) {
  SuiteOptions options = Options(Write("a.yaml", Turning("contacts 0")));
  options.seeds = {1};
  ASSERT_EQ(Run(options), ExitCode::kPassed);
  const fs::path earlier = root_ / "out" / ReadSuiteSummary(root_ / "out").at(0).directory;
  Write("out/notes.txt", "mine");
  options.seeds = {3};
  options.earlier = EarlierResults::kReplace;
  ASSERT_EQ(Run(options), ExitCode::kPassed);
  EXPECT_FALSE(fs::exists(earlier));
  EXPECT_TRUE(fs::exists(root_ / "out" / "notes.txt"));
  const auto runs = ReadSuiteSummary(root_ / "out");
  ASSERT_EQ(runs.size(), 1u);
  EXPECT_EQ(runs[0].seed, 3u);
  EXPECT_TRUE(fs::exists(root_ / "out" / runs[0].directory / "report.html"));
}

TEST_F(SuiteTest, OverwritingLeavesFoldersAloneThatNoSuiteMade) {
  fs::create_directories(root_ / "out" / "thesis");
  Write("scenario.yaml", "a file beside the results folder");
  RunSummary run;
  run.scenario = "a";
  run.backend = "sim";
  std::vector<RunSummary> runs(3, run);
  runs[0].directory = "..";
  runs[1].directory = "thesis";
  runs[2].directory = (root_ / "out" / "thesis").string();
  WriteSuite(root_ / "out", runs);
  SuiteOptions options = Options(Write("a.yaml", Turning("contacts 0")));
  options.earlier = EarlierResults::kReplace;
  ASSERT_EQ(Run(options), ExitCode::kPassed);
  EXPECT_TRUE(fs::exists(root_ / "out" / "thesis"));
  EXPECT_TRUE(fs::exists(root_ / "scenario.yaml"));
}

TEST_F(SuiteTest, ResumePlaysAgainWhatAnotherStackMade) {
  SuiteOptions options = Options(Write("a.yaml", Turning("contacts 0")));
  ASSERT_EQ(Run(options), ExitCode::kPassed);
  const fs::path record =
      root_ / "out" / ReadSuiteSummary(root_ / "out").at(0).directory / "stack.json";
  std::string text = ReadFile(record);
  const std::string radius = "\"radius_m\": ";
  text.replace(text.find(radius) + radius.size(), 1, "9");
  std::ofstream(record) << text;
  options.earlier = EarlierResults::kResume;
  ASSERT_EQ(Run(options), ExitCode::kPassed);
  EXPECT_THAT(err_.str(), HasSubstr("seed 1: passed"));
  EXPECT_NE(ReadFile(record), text);
}

TEST_F(SuiteTest, WallLimitLeavesTheRunIncomplete) {
  SuiteOptions options = Options(Write("long.yaml", Turning("contacts 0", 500)));
  options.wall_limit_s = 1;
  EXPECT_EQ(Run(options), ExitCode::kInfrastructure);
  EXPECT_EQ(ReadSuiteSummary(root_ / "out").at(0).outcome, Outcome::kIncomplete);
}

class RunProcessTest : public SuiteTest {
 protected:
  /// Plays a long run until it has begun to move, then sends its process `signal_number`.
  void PlayAndSignal(int signal_number) {
    const Scenario scenario =
        ParseScenario(Write("long.yaml", Turning("contacts 0", 500)), {ScenesDir()});
    RunProcess process(scenario, root_ / "run", std::nullopt);
    bool sent = false;
    while (process.Poll()) {
      if (!sent && process.sim_s() > 0) kill(process.pid(), signal_number);
      sent = sent || process.sim_s() > 0;
    }
    ASSERT_TRUE(sent);
    finished_ = process.Finish();
  }

  FinishedRun finished_;
};

TEST(StopWithParentTest, EndsAProcessWhoseParentIsGoneAlready) {
  const auto after_tying_to = [](pid_t parent) {
    StopWithParent(parent);
    _exit(0);
  };
  EXPECT_EXIT(after_tying_to(getppid()), testing::ExitedWithCode(0), "");
  EXPECT_EXIT(after_tying_to(getpid()), testing::ExitedWithCode(3), "");
}

TEST_F(RunProcessTest, TerminatedRunSaysThatItIsIncomplete) {
  PlayAndSignal(SIGTERM);
  EXPECT_EQ(finished_.summary.outcome, Outcome::kIncomplete);
  EXPECT_TRUE(fs::exists(root_ / "run" / "report.html"));
}

TEST_F(RunProcessTest, RunKilledBeforeItHasAFolderIsAnError) {
  const Scenario scenario = ParseScenario(Write("a.yaml", Turning("contacts 0")), {ScenesDir()});
  RunProcess process(scenario, Write("file", "") / "run", std::nullopt);
  while (process.Poll()) {
  }
  EXPECT_EQ(process.Finish().summary.outcome, Outcome::kError);
  EXPECT_EQ(process.Finish().exit_code, ExitCode::kInfrastructure);
}

TEST_F(RunProcessTest, KilledRunLeavesReadableResultsMarkedIncomplete) {
  PlayAndSignal(SIGKILL);
  EXPECT_EQ(finished_.summary.outcome, Outcome::kIncomplete);
  EXPECT_EQ(finished_.exit_code, ExitCode::kInfrastructure);
  EXPECT_EQ(finished_.summary.error, "ended by signal 9 (Killed)");
  EXPECT_EQ(ReadSuiteSummary(root_ / "run").at(0).outcome, Outcome::kIncomplete);
  EXPECT_TRUE(fs::exists(root_ / "run" / "frames.csv"));
  EXPECT_FALSE(fs::exists(root_ / "run" / "report.html"));
}

}  // namespace
}  // namespace horopter::scenarios
