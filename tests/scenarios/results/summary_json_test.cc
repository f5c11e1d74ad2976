// SPDX-License-Identifier: Apache-2.0
#include "scenarios/results/summary_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scenarios/results/results_error.h"
#include "tests/scenarios/results/example_run.h"

namespace horopter::scenarios {
namespace {

using ::testing::HasSubstr;

std::string MessageOf(const std::string& text) {
  try {
    ParseSummaryText(text);
  } catch (const ResultsError& error) {
    return error.what();
  }
  return "";
}

TEST(RunSummaryText, RoundTripsEveryField) {
  const RunSummary run = ExampleSummary();
  const std::vector<RunSummary> back = ParseSummaryText(RunSummaryText(run));
  ASSERT_EQ(back.size(), 1u);
  EXPECT_EQ(RunSummaryText(back[0]), RunSummaryText(run));
  EXPECT_EQ(back[0].seed, run.seed);
  EXPECT_EQ(back[0].expectations[1].value, run.expectations[1].value);
  EXPECT_EQ(back[0].expectations[1].detail, run.expectations[1].detail);
  EXPECT_EQ(back[0].expectations[3].value, std::nullopt);
  EXPECT_EQ(back[0].metrics, run.metrics);
  EXPECT_EQ(back[0].versions, run.versions);
  EXPECT_EQ(back[0].machine, run.machine);
  EXPECT_EQ(back[0].timing_ms.at("physics").n, 15000);
  EXPECT_EQ(back[0].wall_s, run.wall_s);
  EXPECT_EQ(back[0].faults, run.faults);
}

TEST(RunSummaryText, HasTheAgreedKeysInTheAgreedForm) {
  const auto json = nlohmann::json::parse(RunSummaryText(ExampleSummary()));
  for (const char* key :
       {"scenario", "seed", "backend", "outcome", "expectations", "image_hash", "decision_hash",
        "timing_ms", "sim_s", "wall_s", "gl_renderer", "machine", "versions"}) {
    EXPECT_TRUE(json.contains(key)) << key;
  }
  EXPECT_EQ(json["outcome"], "failed");
  EXPECT_EQ(json["expectations"][3]["outcome"], "not_applicable");
  EXPECT_EQ(json["timing_ms"]["disparity"]["median"], 41.25);
  EXPECT_EQ(json["timing_ms"]["disparity"]["p95"], 55.5);
  EXPECT_EQ(json["timing_ms"]["disparity"]["n"], 30);
}

TEST(RunSummaryText, SaysNullForWhatNeverWas) {
  RunSummary run;
  run.scenario = "unrun";
  run.backend = "sim";
  run.expectations.push_back(
      {"contacts 0", std::nullopt, 0, "", ExpectationOutcome::kNotApplicable, "contacts", ""});
  run.timing_ms["render"] = {};
  run.metrics["clearance"] = std::nan("");
  const auto json = nlohmann::json::parse(RunSummaryText(run));
  for (const char* key : {"image_hash", "decision_hash", "sim_s", "wall_s", "gl_renderer"}) {
    EXPECT_TRUE(json[key].is_null()) << key;
  }
  for (const char* key : {"processor", "cores", "load"}) {
    EXPECT_TRUE(json["machine"][key].is_null()) << key;
  }
  EXPECT_TRUE(json["expectations"][0]["value"].is_null());
  EXPECT_TRUE(json["timing_ms"]["render"]["median"].is_null());
  EXPECT_TRUE(json["metrics"]["clearance"].is_null());
  const RunSummary back = ParseSummaryText(RunSummaryText(run)).at(0);
  EXPECT_FALSE(back.timing_ms.at("render").median_ms || back.timing_ms.at("render").p95_ms);
  EXPECT_EQ(back.timing_ms.at("render").n, 0);
  EXPECT_EQ(json["outcome"], "incomplete");
}

TEST(RunSummaryText, OfEqualRunsDiffersOnlyInWallClockFields) {
  RunSummary other = ExampleSummary();
  other.wall_s = 99;
  other.timing_ms = {{"disparity", {1, 2, 3}}};
  auto a = nlohmann::ordered_json::parse(RunSummaryText(ExampleSummary()));
  auto b = nlohmann::ordered_json::parse(RunSummaryText(other));
  EXPECT_NE(a, b);
  for (auto* json : {&a, &b}) {
    json->erase("wall_s");
    json->erase("timing_ms");
  }
  EXPECT_EQ(a.dump(), b.dump());
  EXPECT_EQ(RunSummaryText(ExampleSummary()), RunSummaryText(ExampleSummary()));
}

TEST(RunSummaryText, SurvivesTextThatIsNotUtf8) {
  RunSummary run = ExampleSummary();
  run.error = "driver said \xff\x01";
  EXPECT_EQ(ParseSummaryText(RunSummaryText(run))[0].error, "driver said \xEF\xBF\xBD\xEF\xBF\xBD");
}

TEST(SuiteSummaryText, KeepsTheOrderOfItsRuns) {
  RunSummary second = ExampleSummary();
  second.scenario = "a_second";
  const auto runs = ParseSummaryText(SuiteSummaryText({ExampleSummary(), second}));
  ASSERT_EQ(runs.size(), 2u);
  EXPECT_EQ(runs[1].scenario, "a_second");
  EXPECT_TRUE(ParseSummaryText(SuiteSummaryText({})).empty());
}

TEST(ParseSummaryText, NamesThePlaceOfWhatIsWrong) {
  EXPECT_THAT(MessageOf("{"), HasSubstr("not JSON"));
  EXPECT_THAT(MessageOf("[]"), HasSubstr("must be an object"));
  EXPECT_THAT(MessageOf("{\"runs\": 3}"), HasSubstr("runs: must be a list"));
  EXPECT_THAT(MessageOf("{\"runs\": [{}]}"), HasSubstr("runs[0].scenario"));
  auto json = nlohmann::json::parse(SuiteSummaryText({ExampleSummary(), ExampleSummary()}));
  json["runs"][1]["seed"] = -1;
  EXPECT_THAT(MessageOf(json.dump()), HasSubstr("runs[1].seed: must be an integer"));
  json["runs"][1]["seed"] = 1;
  json["runs"][1]["expectations"][2]["outcome"] = "fine";
  EXPECT_THAT(MessageOf(json.dump()),
              HasSubstr("runs[1].expectations[2].outcome: is \"fine\", which is no outcome"));
  json["runs"][1]["expectations"][2]["outcome"] = "passed";
  json["runs"][1]["wall_s"] = "long";
  EXPECT_THAT(MessageOf(json.dump()), HasSubstr("runs[1].wall_s"));
}

TEST(ParseSummaryText, PassesOverKeysItDoesNotKnow) {
  auto json = nlohmann::json::parse(RunSummaryText(ExampleSummary()));
  json["of_the_future"] = {{"a", 1}};
  EXPECT_EQ(ParseSummaryText(json.dump())[0].scenario, "first_waypoint");
}

}  // namespace
}  // namespace horopter::scenarios
