// SPDX-License-Identifier: Apache-2.0
#include "scenarios/results/suite.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scenarios/results/run_writer.h"
#include "tests/scenarios/results/example_run.h"

namespace horopter::scenarios {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

RunSummary NamedRun(const std::string& name, Outcome outcome) {
  RunSummary run = ExampleSummary();
  run.scenario = name;
  run.outcome = outcome;
  run.directory = name + "/seed 1";
  if (outcome == Outcome::kIncomplete) run.sim_s = run.wall_s = std::nullopt;
  return run;
}

TEST(WriteSuite, ReadsBackInOrderAndCanGrow) {
  const ScratchFolder scratch;
  std::vector<RunSummary> runs = {NamedRun("b", Outcome::kPassed),
                                  NamedRun("a", Outcome::kIncomplete)};
  WriteSuite(scratch.path() / "new" / "suite", runs);
  runs[1] = NamedRun("a", Outcome::kFailed);
  WriteSuite(scratch.path() / "new" / "suite", runs);
  const auto back = ReadSuiteSummary(scratch.path() / "new" / "suite");
  ASSERT_EQ(back.size(), 2u);
  EXPECT_EQ(back[0].scenario, "b");
  EXPECT_EQ(back[1].outcome, Outcome::kFailed);
  EXPECT_EQ(back[1].directory, "a/seed 1");
  EXPECT_EQ(ReadSuiteSummary(scratch.path() / "new" / "suite" / "summary.json").size(), 2u);
}

TEST(WriteSuite, LinksToEveryRunsReport) {
  const ScratchFolder scratch;
  WriteSuite(scratch.path(), {NamedRun("a", Outcome::kPassed), NamedRun("b", Outcome::kError),
                              NamedRun("c", Outcome::kIncomplete)});
  const std::string html = ContentOf(scratch.path() / "report.html");
  EXPECT_THAT(html, HasSubstr("href=\"a/seed%201/report.html\""));
  EXPECT_THAT(html, HasSubstr("href=\"b/seed%201/report.html\""));
  EXPECT_THAT(html, HasSubstr("href=\"c/seed%201/\"")) << "a killed run has no report";
  EXPECT_THAT(html, HasSubstr("1 of 3 runs passed"));
  EXPECT_THAT(html, HasSubstr("incomplete"));
}

TEST(WriteSuite, OfNoRunsDoesNotLookPassed) {
  const ScratchFolder scratch;
  WriteSuite(scratch.path(), {});
  EXPECT_TRUE(ReadSuiteSummary(scratch.path()).empty());
  EXPECT_THAT(ContentOf(scratch.path() / "report.html"), Not(HasSubstr("\u2713")));
}

TEST(WriteSuite, NamesThePlaceItCannotWrite) {
  const ScratchFolder scratch;
  std::ofstream(scratch.path() / "file") << "x";
  try {
    WriteSuite(scratch.path() / "file" / "suite", {});
    FAIL();
  } catch (const ResultsError& error) {
    EXPECT_THAT(error.what(), HasSubstr((scratch.path() / "file" / "suite").string()));
  }
}

TEST(ReadSuiteSummary, TakesASingleRunsFolder) {
  const ScratchFolder scratch;
  const RunSummary identity = NamedRun("alone", Outcome::kPassed);
  RunWriter(scratch.path(), "", identity).Finish(identity, {});
  const auto runs = ReadSuiteSummary(scratch.path());
  ASSERT_EQ(runs.size(), 1u);
  EXPECT_EQ(runs[0].scenario, "alone");
}

std::string MessageOf(const fs::path& place) {
  try {
    ReadSuiteSummary(place);
  } catch (const ResultsError& error) {
    return error.what();
  }
  return "";
}

TEST(ReadSuiteSummary, NamesFileAndReason) {
  const ScratchFolder scratch;
  const std::string file = (scratch.path() / "summary.json").string();
  EXPECT_THAT(MessageOf(scratch.path()), HasSubstr(file + ": No such file"));
  std::ofstream(file) << "{\"runs\": [";
  EXPECT_THAT(MessageOf(scratch.path()), HasSubstr(file + ": is not JSON"));
  std::ofstream(file) << "{\"runs\": [{\"scenario\": 3}]}";
  EXPECT_THAT(MessageOf(scratch.path()), HasSubstr(file + ": runs[0].scenario"));
}

}  // namespace
}  // namespace horopter::scenarios
