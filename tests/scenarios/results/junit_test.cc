// SPDX-License-Identifier: Apache-2.0
#include "scenarios/results/junit.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <pugixml.hpp>

#include "tests/scenarios/results/example_run.h"

namespace horopter::scenarios {
namespace {

pugi::xml_document Parsed(const std::vector<RunSummary>& runs) {
  pugi::xml_document document;
  const auto result = document.load_string(JunitXml(runs).c_str());
  EXPECT_TRUE(result) << result.description();
  return document;
}

RunSummary ErrorRun() {
  RunSummary run = ExampleSummary();
  run.outcome = Outcome::kError;
  run.error = "MuJoCo: NaN in QACC & \x02 <state>";
  return run;
}

std::string PropertyOf(const pugi::xml_node& suite, const std::string& name) {
  return suite.child("properties")
      .find_child_by_attribute("name", name.c_str())
      .attribute("value")
      .value();
}

TEST(Junit, HasASuitePerRunAndACasePerExpectation) {
  const auto document = Parsed({ExampleSummary()});
  const pugi::xml_node suite = document.child("testsuites").child("testsuite");
  EXPECT_EQ(suite.attribute("tests").as_int(), 5);
  EXPECT_EQ(suite.attribute("failures").as_int(), 1);
  EXPECT_EQ(suite.attribute("errors").as_int(), 0);
  EXPECT_EQ(suite.attribute("skipped").as_int(), 1);
  const auto cases = suite.children("testcase");
  EXPECT_EQ(std::distance(cases.begin(), cases.end()), 5);
  const pugi::xml_node failed = suite.find_child_by_attribute("name", "clearance >= 0.05 m");
  EXPECT_STREQ(failed.child("failure").attribute("message").value(),
               ExampleSummary().expectations[1].detail.c_str());
  EXPECT_TRUE(
      suite.find_child_by_attribute("name", "fixation.error_deg.p95 <= 0.5").child("skipped"));
  EXPECT_FALSE(suite.find_child_by_attribute("name", "contacts 0").first_child());
}

TEST(Junit, KeepsSeedAndExpectationsAsPropertiesOfTheSuite) {
  const auto document = Parsed({ExampleSummary()});
  const pugi::xml_node suite = document.child("testsuites").child("testsuite");
  EXPECT_EQ(PropertyOf(suite, "seed"), "18446744073709551615");
  EXPECT_EQ(PropertyOf(suite, "clearance >= 0.05 m.value"), "0.031415926535897934");
  EXPECT_EQ(PropertyOf(suite, "clearance >= 0.05 m.limit"), "0.05");
  EXPECT_EQ(PropertyOf(suite, "clearance >= 0.05 m.unit"), "m");
  EXPECT_EQ(PropertyOf(suite, "fixation.error_deg.p95 <= 0.5.value"), "") << "never had one";
}

TEST(Junit, TellsErrorsFromFailures) {
  RunSummary incomplete;
  incomplete.scenario = "killed";
  const auto document = Parsed({ErrorRun(), incomplete});
  const pugi::xml_node suites = document.child("testsuites");
  EXPECT_EQ(suites.attribute("errors").as_int(), 2);
  EXPECT_EQ(suites.attribute("failures").as_int(), 1);
  EXPECT_EQ(suites.attribute("tests").as_int(), 7);
  const pugi::xml_node killed = suites.find_child_by_attribute("name", "killed seed 0");
  EXPECT_STREQ(killed.child("testcase").child("error").attribute("type").value(), "incomplete");
  EXPECT_FALSE(killed.attribute("time")) << "a time that never was is left out";
}

TEST(Junit, RunThatGaveUpIsAFailureWhateverItsExpectationsSay) {
  RunSummary stuck = ExampleSummary();
  stuck.expectations.resize(1);  // passed
  stuck.error = "goto: stuck: no way round";
  const auto document = Parsed({stuck});
  const pugi::xml_node suites = document.child("testsuites");
  EXPECT_EQ(suites.attribute("failures").as_int(), 1);
  EXPECT_EQ(suites.attribute("errors").as_int(), 0);
  EXPECT_EQ(suites.attribute("tests").as_int(), 2);
  const pugi::xml_node run =
      suites.child("testsuite").find_child_by_attribute("testcase", "name", "run");
  EXPECT_STREQ(run.child("failure").attribute("message").value(), stuck.error.c_str());
  EXPECT_STREQ(run.child("failure").attribute("type").value(), "failed");
}

TEST(Junit, IsValidAgainstTheSchema) {
  ASSERT_EQ(std::system("command -v xmllint > /dev/null 2>&1"), 0)
      << "xmllint is missing (Debian package libxml2-utils)";
  const ScratchFolder folder;
  RunSummary hostile = ErrorRun();
  hostile.scenario = "]]> \"'<&> \xff";
  hostile.file = "a & b.yaml";
  hostile.wall_s = 1e7;
  RunSummary skeleton;
  skeleton.scenario = "killed";
  RunSummary stuck = ExampleSummary();
  stuck.error = "goto: stuck";
  const std::vector<std::vector<RunSummary>> cases = {
      {}, {ExampleSummary()}, {ExampleSummary(), hostile, skeleton, stuck}};
  for (const auto& runs : cases) {
    const auto file = folder.path() / "junit.xml";
    std::ofstream(file) << JunitXml(runs);
    const std::string command = "xmllint --noout --nonet --schema " HOROPTER_SOURCE_DIR
                                "/tests/scenarios/results/junit.xsd '" +
                                file.string() + "' > '" + (folder.path() / "log").string() +
                                "' 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0)
        << ContentOf(folder.path() / "log") << ContentOf(file);
  }
}

}  // namespace
}  // namespace horopter::scenarios
