// SPDX-License-Identifier: Apache-2.0
#include "scenarios/format/expectation_parser.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <regex>
#include <set>

#include "scenarios/format/metric_registry.h"

namespace horopter::scenarios {
namespace {

Expectation Parsed(const std::string& sentence) {
  auto result = ParseExpectation(sentence);
  if (const auto* fault = std::get_if<std::string>(&result)) {
    ADD_FAILURE() << sentence << ": " << *fault;
    return {};
  }
  return std::get<Expectation>(result);
}

std::string Fault(const std::string& sentence) {
  const auto result = ParseExpectation(sentence);
  const auto* fault = std::get_if<std::string>(&result);
  return fault != nullptr ? *fault : "";
}

TEST(Expectation, ReachedKeepsDistanceAndTime) {
  const Expectation e = Parsed("reached  within 15 cm\n before 1500 ms");
  EXPECT_EQ(e.text, "reached within 15 cm before 1500 ms");
  EXPECT_EQ(e.metric, "reached");
  EXPECT_EQ(e.comparison, Comparison::kAtMost);
  EXPECT_DOUBLE_EQ(e.limit, 0.15);
  EXPECT_EQ(e.unit, "m");
  ASSERT_TRUE(e.before_s);
  EXPECT_DOUBLE_EQ(*e.before_s, 1.5);
}

TEST(Expectation, UnitsConvertToTheMetricsOwn) {
  EXPECT_DOUBLE_EQ(Parsed("clearance >= 5 cm").limit, 0.05);
  EXPECT_DOUBLE_EQ(Parsed("clearance >= 50mm").limit, 0.05);
  EXPECT_DOUBLE_EQ(Parsed("clearance >= 0.05").limit, 0.05);
  EXPECT_EQ(Parsed("clearance >= 0.05").unit, "m");
  EXPECT_NEAR(Parsed("fixation.error_deg.max < 0.01 rad").limit, 0.01 * 180 / M_PI, 1e-15);
  EXPECT_DOUBLE_EQ(Parsed("depth.density >= 40%").limit, 0.4);
  EXPECT_DOUBLE_EQ(Parsed("depth.bias >= -2 cm").limit, -0.02);
}

TEST(Expectation, OperatorsAndTheirDefault) {
  EXPECT_EQ(Parsed("contacts 0").comparison, Comparison::kEqual);
  for (Comparison c : {Comparison::kAtMost, Comparison::kAtLeast, Comparison::kLess,
                       Comparison::kGreater, Comparison::kEqual}) {
    EXPECT_EQ(Parsed(std::string("contacts ") + ToString(c) + "3").comparison, c);
  }
}

TEST(Expectation, FaultsNameTheRemedy) {
  EXPECT_THAT(Fault("clearence >= 1 m"), testing::HasSubstr("did you mean 'clearance'?"));
  EXPECT_THAT(Fault("clearance => 1 m"), testing::HasSubstr("write <=, >=, <, > or =="));
  EXPECT_THAT(Fault("clearance >= 1 deg"), testing::HasSubstr("written in m, cm, mm"));
  EXPECT_THAT(Fault("clearance >= 1 mmm"), testing::HasSubstr("unknown unit 'mmm'"));
  EXPECT_THAT(Fault("clearance >= 1 mmm"), testing::HasSubstr("did you mean 'mm'?"));
  EXPECT_THAT(Fault("contacts 0 m"), testing::HasSubstr("no unit"));
  EXPECT_THAT(Fault("depth.density >= 40"), testing::HasSubstr("40 %"));
  EXPECT_THAT(Fault("clearance >= -1 m"), testing::HasSubstr("never negative"));
  EXPECT_THAT(Fault("clearance >= 1e999 m"), testing::HasSubstr("too large"));
  EXPECT_THAT(Fault("clearance >= nan"), testing::HasSubstr("no number"));
}

TEST(MetricRegistry, NamesAreUniqueAndEveryOneCanBeExpected) {
  const std::regex pattern("^(" + ExpectationPattern() + ")$");
  std::set<std::string> names;
  for (const Metric& metric : Metrics()) {
    EXPECT_TRUE(names.insert(metric.name).second) << metric.name;
    EXPECT_FALSE(metric.doc.empty()) << metric.name;
    const std::string sentence = metric.name + " <= 1 " + metric.unit;
    EXPECT_EQ(Parsed(sentence).unit, metric.unit);
    EXPECT_TRUE(std::regex_match(sentence, pattern)) << sentence;
  }
}

// The published pattern and the parser are two readings of one grammar.
TEST(Expectation, PatternAgreesWithTheParserOnRandomSentences) {
  const std::vector<std::string> pieces = {"reached",
                                           "within",
                                           "before",
                                           "contacts",
                                           "clearance",
                                           "depth.bias",
                                           "depth.density",
                                           "fixation.error_deg.p95",
                                           " ",
                                           " ",
                                           " ",
                                           "  ",
                                           "<=",
                                           ">",
                                           "=",
                                           "==",
                                           "0",
                                           "0.5",
                                           ".5",
                                           "1e-3",
                                           "-",
                                           "+",
                                           "m",
                                           "cm",
                                           "s",
                                           "deg",
                                           "%",
                                           "e",
                                           ".",
                                           "0.1 m",
                                           "60 s",
                                           " 1 "};
  const std::vector<std::string> starts = {"",
                                           "contacts ",
                                           "clearance >= ",
                                           "reached within ",
                                           "reached within 0.1 m before ",
                                           "depth.bias ",
                                           "depth.density <"};
  const std::regex pattern("^(" + ExpectationPattern() + ")$");
  std::mt19937 random(7);
  int accepted = 0;
  for (int i = 0; i < 4000; ++i) {
    std::string sentence = starts[random() % starts.size()];
    for (std::size_t n = random() % 4; n > 0; --n) sentence += pieces[random() % pieces.size()];
    const bool parses = Fault(sentence).empty();
    EXPECT_EQ(parses, std::regex_match(sentence, pattern)) << "'" << sentence << "'";
    accepted += parses;
  }
  EXPECT_GT(accepted, 100);  // the generator does reach sentences that are right
}

}  // namespace
}  // namespace horopter::scenarios
