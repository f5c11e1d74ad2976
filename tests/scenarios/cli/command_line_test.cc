// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "scenarios/results/suite.h"
#include "tests/scenarios/cli/horopter_program.h"
#include "tests/scenarios/format/corpus.h"

namespace horopter::scenarios {
namespace {

using testing::HasSubstr;

void ExpectUsageError(const std::string& arguments, const std::string& remedy) {
  const Ran ran = Horopter(arguments);
  EXPECT_EQ(ran.code, 2) << arguments << "\n" << ran.output;
  EXPECT_THAT(ran.output, HasSubstr(remedy)) << arguments;
  EXPECT_EQ(std::count(ran.output.begin(), ran.output.end(), '\n'), 1) << ran.output;
}

constexpr const char* kShipped = HOROPTER_SOURCE_DIR "/scenarios/koala/first_waypoint.yaml";

TEST(CommandLine, HelpHasAnExampleEverywhere) {
  for (const char* command :
       {"", "run", "list", "validate", "compare", "render", "disparity", "score", "doctor", "schema",
        "timing"}) {
    const Ran ran = Horopter(std::string(command) + " --help");
    EXPECT_EQ(ran.code, 0) << command;
    EXPECT_THAT(ran.output, HasSubstr(std::string("  horopter ") + command)) << command;
    EXPECT_THAT(ran.output, HasSubstr("Example"));
  }
  EXPECT_THAT(Horopter("--version").output,
              testing::MatchesRegex("horopter [0-9]+\\.[0-9]+\\.[0-9]+ \\([-0-9a-z]+\\)\n"));
  EXPECT_EQ(Horopter("--version").code, 0);
}

TEST(CommandLine, NothingToDoIsAUsageErrorWithHelp) {
  const Ran ran = Horopter("");
  EXPECT_EQ(ran.code, 2);
  EXPECT_THAT(ran.output, HasSubstr("Examples"));
}

TEST(CommandLine, MistypedWordsGetASuggestion) {
  ExpectUsageError("rnu scenarios", "unknown command 'rnu'; did you mean 'run'?");
  ExpectUsageError("run x --sed 3", "unknown option '--sed'; did you mean '--seed'?");
  ExpectUsageError("list --jsno", "did you mean '--json'?");
  ExpectUsageError("--verison", "did you mean '--version'?");
  ExpectUsageError("compare a", "NEW");
  ExpectUsageError("compare a b c", "unexpected argument 'c'");
}

TEST(CommandLine, BadValuesAreUsageErrors) {
  const std::string run = std::string("run '") + kShipped + "' ";
  ExpectUsageError(run + "--seeds 5-1", "runs backwards");
  ExpectUsageError(run + "--seeds 1-99999999", "more than 10000");
  ExpectUsageError(run + "--seed x", "no seed");
  ExpectUsageError(run + "--seed 1-3", "--seeds 1-3");
  ExpectUsageError(run + "--seed 1 --seeds 1-3", "--seed");
  ExpectUsageError(run + "--jobs 0", "--jobs");
  ExpectUsageError(run + "--jobs many", "--jobs");
  ExpectUsageError(run + "--time-limit -1", "--time-limit");
  ExpectUsageError(run + "--resume", "--out");
  ExpectUsageError(run + "--overwrite", "--out");
  ExpectUsageError(run + "--out x --resume --overwrite", "--resume");
  ExpectUsageError(run + "--backend simm", "did you mean 'sim'?");
  ExpectUsageError("run no/such/folder", "no such file or folder");
  ExpectUsageError("run --tag koala no/such/folder", "no such file or folder");
}

TEST(CommandLine, KnownBackendsThatAreNotThereExitWithFour) {
  for (const char* backend : {"hardware", "emulated", "replay"}) {
    const Ran ran = Horopter(std::string("run '") + kShipped + "' --backend " + backend);
    EXPECT_EQ(ran.code, 4) << ran.output;
    EXPECT_THAT(ran.output, HasSubstr(std::string("backend '") + backend + "' is not available"));
  }
}

TEST(CommandLine, ValidateNamesPlaceAndRemedy) {
  EXPECT_EQ(Horopter(std::string("validate '") + kShipped + "'").code, 0);
  TemporaryFolder folder;
  const auto bad = folder.Write("bad.yaml",
                                "scene: koala/room.xml\ncamera: {widht: 3}\n"
                                "steps:\n  - wait: {duration_s: 1}\nexpect: []\n");
  const Ran ran = Horopter("validate '" + bad.string() + "'");
  EXPECT_EQ(ran.code, 2);
  EXPECT_EQ(ran.output,
            bad.string() + ":2:10: camera: unknown key 'widht'; did you mean 'width'?\n");
}

TEST(CommandLine, ListGivesJson) {
  const Ran ran = Horopter("list --json", "");
  EXPECT_EQ(ran.code, 0);
  const nlohmann::json list = nlohmann::json::parse(ran.output);
  ASSERT_FALSE(list.empty());
  for (const auto& scenario : list) {
    for (const char* key : {"file", "name", "tags", "description", "steps"}) {
      EXPECT_TRUE(scenario.contains(key)) << key;
    }
  }
}

TEST(CommandLine, SchemaIsThePublishedOne) {
  EXPECT_EQ(Horopter("schema", "").output,
            Slurp(HOROPTER_SOURCE_DIR "/scenarios/schema/scenario.schema.json"));
  EXPECT_TRUE(nlohmann::json::accept(Horopter("schema --robot", "").output));
}

TEST(CommandLine, DoctorTellsWhatIsThere) {
  const nlohmann::json d = nlohmann::json::parse(Horopter("doctor --json", "").output);
  EXPECT_GT(d.at("cores"), 0);
  EXPECT_TRUE(d.at("versions").contains("mujoco"));
  bool sim = false;
  for (const auto& backend : d.at("backends")) {
    sim = sim || (backend.at("name") == "sim" && backend.at("usable"));
    EXPECT_EQ(backend.at("usable"), backend.at("problem") == "");
  }
  EXPECT_TRUE(sim);
  const Ran without = Horopter("doctor", "2>&1; true");
  EXPECT_THAT(without.output, HasSubstr("Rendering"));
}

TEST(CommandLine, CompareJudgesResultFolders) {
  TemporaryFolder folder;
  RunSummary run;
  run.scenario = "a";
  run.backend = "sim";
  run.seed = 1;
  run.outcome = Outcome::kPassed;
  std::filesystem::create_directories(folder.path() / "old");
  std::filesystem::create_directories(folder.path() / "new");
  WriteSuite(folder.path() / "old", {run});
  run.outcome = Outcome::kFailed;
  WriteSuite(folder.path() / "new", {run});
  const std::string old_dir = "'" + (folder.path() / "old").string() + "' ";
  const std::string new_dir = "'" + (folder.path() / "new").string() + "' ";
  EXPECT_EQ(Horopter("compare " + old_dir + old_dir).code, 0);
  const Ran ran = Horopter("compare " + old_dir + new_dir);
  EXPECT_EQ(ran.code, 1);
  EXPECT_THAT(ran.output, HasSubstr("WORSE"));
  EXPECT_EQ(Horopter("compare " + old_dir + "'" + (folder.path() / "none").string() + "'").code, 2);
}

TEST(CommandLine, CompareCountsWhatIsMissingAsARegressionUnlessAllowed) {
  TemporaryFolder folder;
  RunSummary run;
  run.scenario = "a";
  run.backend = "sim";
  run.outcome = Outcome::kPassed;
  run.metrics["clearance"] = 0.1;
  RunSummary second = run;
  second.seed = 2;
  RunSummary bare = run;
  bare.metrics.clear();
  const auto write = [&folder](const char* name, const std::vector<RunSummary>& runs) {
    WriteSuite(folder.path() / name, runs);
    return " '" + (folder.path() / name).string() + "'";
  };
  const std::string both = write("both", {run, second});
  for (const std::string& fewer : {write("run", {run}), write("metric", {bare, second})}) {
    EXPECT_EQ(Horopter("compare" + both + fewer).code, 1) << fewer;
    EXPECT_THAT(Horopter("compare" + both + fewer).output, HasSubstr("--allow-missing"));
    EXPECT_EQ(Horopter("compare --allow-missing" + both + fewer).code, 0) << fewer;
    EXPECT_EQ(Horopter("compare" + fewer + both).code, 0) << fewer;
  }
  const Ran ran = Horopter("compare" + both + write("twice", {run, run}));
  EXPECT_EQ(ran.code, 2);
  EXPECT_THAT(ran.output, HasSubstr("two runs are both 'a, seed 0, sim'"));
}

TEST(CommandLine, ResultsThatCannotBeReadAreBadInputInEveryCommand) {
  TemporaryFolder folder;
  const std::string none = "'" + (folder.path() / "none").string() + "'";
  const std::string broken = "'" + folder.Write("summary.json", "{").string() + "'";
  for (const std::string& results : {none, broken}) {
    for (const std::string& command : {"timing " + results, "compare " + results + " " + results}) {
      const Ran ran = Horopter(command);
      const std::string name = command.substr(0, command.find(' '));
      EXPECT_EQ(ran.code, 2) << ran.output;
      EXPECT_THAT(ran.output, testing::StartsWith("horopter " + name + ": ")) << command;
      EXPECT_EQ(std::count(ran.output.begin(), ran.output.end(), '\n'), 1) << ran.output;
    }
  }
}

TEST(CommandLine, TimingPrintsATableOverRuns) {
  TemporaryFolder folder;
  RunSummary run;
  run.scenario = "a";
  run.backend = "sim";
  run.timing_ms = {{"disparity", {40, 50, 30}}, {"render", {}}};
  RunSummary other = run;
  other.seed = 2;
  other.timing_ms["disparity"] = {44, 70, 10};
  run.machine = {"A Processor", 2, 0.25};
  other.machine = {"A Processor", 2, 1.5};
  WriteSuite(folder.path() / "suite", {run, other});
  const Ran ran = Horopter("timing '" + (folder.path() / "suite").string() + "'", "");
  EXPECT_EQ(ran.code, 0);
  EXPECT_EQ(ran.output,
            "A Processor, 2 cores; load when the runs began 0.25 to 1.50\n\n"
            "| stage | median ms | worst run's 95 % ms | passes |\n"
            "|---|---:|---:|---:|\n"
            "| disparity | 42.000 | 70.000 | 40 |\n"
            "| render | - | - | 0 |\n");
}

}  // namespace
}  // namespace horopter::scenarios
