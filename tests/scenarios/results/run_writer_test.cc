// SPDX-License-Identifier: Apache-2.0
#include "scenarios/results/run_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <optional>

#include "scenarios/results/files.h"
#include "scenarios/results/suite.h"
#include "scenarios/results/tables.h"
#include "tests/scenarios/results/example_run.h"

namespace horopter::scenarios {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

std::vector<std::string> LinesOf(const fs::path& file) {
  std::ifstream in(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::vector<std::string> NamesIn(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename());
  std::sort(names.begin(), names.end());
  return names;
}

RunSummary Identity() {
  RunSummary identity;
  identity.scenario = "first_waypoint";
  identity.backend = "sim";
  identity.seed = 3;
  identity.outcome = Outcome::kPassed;  // not to be believed before the run has ended
  return identity;
}

void WriteWholeRun(const fs::path& folder, const RunSummary& summary) {
  RunWriter writer(folder, "name: first_waypoint\n", Identity());
  for (int i = 0; i < 6; ++i) {
    writer.AddFrame(ExampleFrame(i), i % 2 == 0 ? ExampleImages(i, {64, 48}) : FrameImages{});
  }
  for (const PathPoint& point : ExamplePlan().path) writer.AddPathPoint(point);
  PlanRecord plan = ExamplePlan();
  plan.path.clear();
  writer.Finish(summary, plan);
}

TEST(RunWriter, LeavesEverythingThatAResultsFolderHolds) {
  const ScratchFolder scratch;
  const fs::path folder = scratch.path() / "a" / "run";
  WriteWholeRun(folder, ExampleSummary());
  EXPECT_THAT(
      NamesIn(folder),
      ::testing::ElementsAre("frames", "frames.csv", "junit.xml", "plan.json", "plan.svg",
                             "report.html", "scenario.yaml", "summary.json", "trajectory.csv"));
  EXPECT_EQ(LinesOf(folder / "frames.csv").size(), 7u);
  EXPECT_EQ(LinesOf(folder / "trajectory.csv").size(), 302u);
  EXPECT_EQ(NamesIn(folder / "frames").size(), 21u) << "three frames of seven pictures";
  EXPECT_EQ(ReadSuiteSummary(folder).at(0).outcome, Outcome::kFailed);
  EXPECT_EQ(ContentOf(folder / "scenario.yaml"), "name: first_waypoint\n");
  const auto plan = nlohmann::json::parse(ContentOf(folder / "plan.json"));
  EXPECT_EQ(plan["path"].size(), 301u) << "the path that AddPathPoint was given";
}

TEST(RunWriter, StoresPicturesWithoutLoss) {
  const ScratchFolder scratch;
  WriteWholeRun(scratch.path(), ExampleSummary());
  const FrameImages images = ExampleImages(2, {64, 48});
  const cv::Mat back = cv::imread((scratch.path() / "frames/0002_depth_error.png").string());
  ASSERT_FALSE(back.empty());
  EXPECT_EQ(cv::norm(back, images.depth_error_bgr), 0);
}

TEST(RunWriter, SaysIncompleteUntilItIsFinished) {
  const ScratchFolder scratch;
  {
    RunWriter writer(scratch.path(), "", Identity());
    EXPECT_EQ(ReadSuiteSummary(scratch.path()).at(0).outcome, Outcome::kIncomplete);
    writer.AddFrame(ExampleFrame(0));
  }
  const RunSummary left = ReadSuiteSummary(scratch.path()).at(0);
  EXPECT_EQ(left.outcome, Outcome::kIncomplete);
  EXPECT_EQ(left.scenario, "first_waypoint");
  EXPECT_EQ(left.seed, 3u);
  EXPECT_EQ(left.wall_s, std::nullopt);
  EXPECT_FALSE(fs::exists(scratch.path() / "report.html"));
  EXPECT_FALSE(fs::exists(scratch.path() / "junit.xml"));
}

TEST(RunWriter, ReplacesAnEarlierRunButNotStrangersFiles) {
  const ScratchFolder scratch;
  WriteWholeRun(scratch.path(), ExampleSummary());
  std::ofstream(scratch.path() / "notes.txt") << "mine";
  const RunWriter writer(scratch.path(), "", Identity());
  EXPECT_THAT(NamesIn(scratch.path()),
              ::testing::ElementsAre("frames", "frames.csv", "notes.txt", "scenario.yaml",
                                     "summary.json", "trajectory.csv"));
  EXPECT_TRUE(NamesIn(scratch.path() / "frames").empty());
  EXPECT_EQ(LinesOf(scratch.path() / "frames.csv").size(), 1u);
}

TEST(RunWriter, OfEqualRunsWritesEqualFiles) {
  const ScratchFolder one;
  const ScratchFolder two;
  WriteWholeRun(one.path(), ExampleSummary());
  WriteWholeRun(two.path(), ExampleSummary());
  for (const char* file : {"summary.json", "junit.xml", "report.html", "plan.json", "plan.svg",
                           "frames.csv", "trajectory.csv", "frames/0004_regions.png"}) {
    EXPECT_EQ(ContentOf(one.path() / file), ContentOf(two.path() / file)) << file;
  }
}

// The rows must be there without Finish, destructors or a flush at exit.
TEST(RunWriter, KilledProcessLeavesReadableRowsAndAnIncompleteSummary) {
  const ScratchFolder scratch;
  int ready[2];
  ASSERT_EQ(::pipe(ready), 0);
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    RunWriter writer(scratch.path(), "name: killed\n", Identity());
    for (int i = 0; i < 5; ++i) writer.AddFrame(ExampleFrame(i));
    for (int i = 0; i < 40; ++i) writer.AddPathPoint(ExamplePlan().path[i]);
    const char done = 'd';
    if (::write(ready[1], &done, 1) != 1) ::_exit(1);
    for (;;) ::pause();
  }
  char done = 0;
  ASSERT_EQ(::read(ready[0], &done, 1), 1);
  ASSERT_EQ(::kill(child, SIGKILL), 0);
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
  ::close(ready[0]);
  ::close(ready[1]);

  const auto rows = LinesOf(scratch.path() / "frames.csv");
  ASSERT_EQ(rows.size(), 6u);
  EXPECT_EQ(rows.front(), FrameTableHeader());
  EXPECT_EQ(rows.back(), FrameTableRow(ExampleFrame(4)));
  EXPECT_EQ(LinesOf(scratch.path() / "trajectory.csv").size(), 41u);
  EXPECT_EQ(ReadSuiteSummary(scratch.path()).at(0).outcome, Outcome::kIncomplete);
}

TEST(RunWriter, StaysIncompleteWhenItsReportCannotBeWritten) {
  const ScratchFolder scratch;
  RunWriter writer(scratch.path(), "", Identity());
  fs::create_directories(scratch.path() / "report.html" / "in_the_way");
  RunSummary passed = ExampleSummary();
  passed.outcome = Outcome::kPassed;
  EXPECT_THROW(writer.Finish(passed, ExamplePlan()), ResultsError);
  EXPECT_EQ(ReadSuiteSummary(scratch.path()).at(0).outcome, Outcome::kIncomplete);
  for (const std::string& name : NamesIn(scratch.path())) {
    EXPECT_EQ(name.find(".tmp"), std::string::npos) << name;
  }
}

std::string MessageOf(const fs::path& folder) {
  try {
    const RunWriter writer(folder, "", Identity());
  } catch (const ResultsError& error) {
    return error.what();
  }
  return "";
}

TEST(RunWriter, NamesPlaceReasonAndRemedyWhenItCannotWrite) {
  const ScratchFolder scratch;
  const fs::path file = scratch.path() / "regular_file";
  std::ofstream(file) << "x";
  for (const fs::path& folder : {file, file / "below", file / "far" / "below"}) {
    const std::string message = MessageOf(folder);
    EXPECT_THAT(message, HasSubstr(folder.string()));
    EXPECT_THAT(message, HasSubstr("directory"));
    EXPECT_THAT(message, HasSubstr("--out"));
    EXPECT_EQ(message.find('\n'), std::string::npos);
  }
}

TEST(RunWriter, RefusesPicturesOfAnotherType) {
  const ScratchFolder scratch;
  RunWriter writer(scratch.path(), "", Identity());
  FrameImages images;
  images.depth_bgr = cv::Mat(4, 4, CV_32FC1, cv::Scalar(1));
  EXPECT_THROW(writer.AddFrame(ExampleFrame(0), images), std::invalid_argument);
}

TEST(WriteFileAtomically, KeepsTheOldContentWhenItFails) {
  const ScratchFolder scratch;
  const fs::path file = scratch.path() / "content";
  WriteFileAtomically(file, "old");
  WriteFileAtomically(file, "new");
  EXPECT_EQ(ContentOf(file), "new");
  fs::create_directories(scratch.path() / "taken" / "inside");
  EXPECT_THROW(WriteFileAtomically(scratch.path() / "taken", "x"), ResultsError);
  EXPECT_THAT(NamesIn(scratch.path()), ::testing::ElementsAre("content", "taken"));
}

TEST(WriteFully, ReportsAFullDisk) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "NOT CHECKED: no /dev/full here";
  try {
    AppendFile file("/dev/full", "header");
    FAIL() << "a full disk went unnoticed";
  } catch (const ResultsError& error) {
    EXPECT_THAT(error.what(), HasSubstr("No space left"));
    EXPECT_THAT(error.what(), HasSubstr("free some space"));
  }
}

TEST(FrameTable, HasAsManyFieldsInEveryRowAsInItsHeader) {
  FrameRecord bare;
  bare.decision = "stop, \"now\"";
  FrameRecord no_density = ExampleFrame(1);
  no_density.depth->density = std::nan("");
  for (const FrameRecord& frame : {ExampleFrame(23), bare, no_density}) {
    std::string row = FrameTableRow(frame);
    bool quoted = false;
    const auto commas = std::count_if(row.begin(), row.end(), [&](char c) {
      if (c == '"') quoted = !quoted;
      return c == ',' && !quoted;
    });
    EXPECT_EQ(commas, std::count(FrameTableHeader().begin(), FrameTableHeader().end(), ',')) << row;
  }
  PathPoint point;
  const std::string row = PathTableRow(point);
  EXPECT_EQ(std::count(row.begin(), row.end(), ','),
            std::count(PathTableHeader().begin(), PathTableHeader().end(), ','));
}

}  // namespace
}  // namespace horopter::scenarios
