// SPDX-License-Identifier: Apache-2.0
#include "scenarios/results/junit.h"

#include <fmt/format.h>

#include <pugixml.hpp>
#include <sstream>

#include "scenarios/results/text.h"

namespace horopter::scenarios {
namespace {

struct Counts {
  int tests = 0;
  int failures = 0;
  int errors = 0;
  int skipped = 0;
};

void Set(pugi::xml_node node, const char* name, const std::string& value) {
  node.append_attribute(name).set_value(CleanText(value).c_str());
}

/// Plain decimals: the schema's pattern for times has no exponent.
std::string Seconds(double seconds) { return fmt::format("{:.3f}", seconds); }

bool Ended(const RunSummary& run) {
  return run.outcome == Outcome::kPassed || run.outcome == Outcome::kFailed;
}

/// A run that failed before its expectations could tell: a step gave up, or time ran out.
bool GaveUp(const RunSummary& run) { return run.outcome == Outcome::kFailed && !run.error.empty(); }

Counts Count(const RunSummary& run) {
  Counts counts;
  counts.errors = !Ended(run);
  counts.failures = GaveUp(run);
  counts.tests = static_cast<int>(run.expectations.size()) + counts.errors + counts.failures;
  for (const ExpectationResult& e : run.expectations) {
    counts.failures += e.outcome == ExpectationOutcome::kFailed;
    counts.skipped += e.outcome == ExpectationOutcome::kNotApplicable;
  }
  return counts;
}

void AddProperty(pugi::xml_node properties, const std::string& name, const std::string& value) {
  pugi::xml_node property = properties.append_child("property");
  Set(property, "name", name);
  Set(property, "value", value);
}

void AddProperties(pugi::xml_node suite, const RunSummary& run) {
  pugi::xml_node properties = suite.append_child("properties");
  AddProperty(properties, "seed", std::to_string(run.seed));
  AddProperty(properties, "backend", run.backend);
  if (!run.gl_renderer.empty()) AddProperty(properties, "gl_renderer", run.gl_renderer);
  if (!run.image_hash.empty()) AddProperty(properties, "image_hash", run.image_hash);
  if (!run.decision_hash.empty()) AddProperty(properties, "decision_hash", run.decision_hash);
  for (const ExpectationResult& e : run.expectations) {
    if (e.value) AddProperty(properties, e.name + ".value", ExactNumber(e.value));
    AddProperty(properties, e.name + ".limit", ExactNumber(e.limit));
    AddProperty(properties, e.name + ".unit", e.unit);
  }
}

pugi::xml_node AddCase(pugi::xml_node suite, const RunSummary& run, const std::string& name) {
  pugi::xml_node testcase = suite.append_child("testcase");
  Set(testcase, "name", name);
  Set(testcase, "classname", run.scenario);
  return testcase;
}

std::string Sentence(const ExpectationResult& e) {
  if (!e.detail.empty()) return e.detail;
  if (e.outcome == ExpectationOutcome::kNotApplicable) return "not judged in this run";
  return fmt::format("{}: value {}, limit {}{}{}", e.name, ShortNumber(e.value),
                     ShortNumber(e.limit), e.unit.empty() ? "" : " ", e.unit);
}

void AddExpectation(pugi::xml_node suite, const RunSummary& run, const ExpectationResult& e) {
  pugi::xml_node testcase = AddCase(suite, run, e.name);
  if (e.outcome == ExpectationOutcome::kPassed) return;
  const bool failed = e.outcome == ExpectationOutcome::kFailed;
  pugi::xml_node result = testcase.append_child(failed ? "failure" : "skipped");
  Set(result, "type", failed ? "expectation" : "not_applicable");
  Set(result, "message", Sentence(e));
}

/// The run itself as a testcase, when it did not come to its end.
void AddRun(pugi::xml_node suite, const RunSummary& run) {
  if (Ended(run) && !GaveUp(run)) return;
  pugi::xml_node result = AddCase(suite, run, "run").append_child(Ended(run) ? "failure" : "error");
  Set(result, "type", ToString(run.outcome));
  Set(result, "message", run.error.empty() ? "the run did not finish" : run.error);
}

void AddSuite(pugi::xml_node suites, const RunSummary& run) {
  const Counts counts = Count(run);
  pugi::xml_node suite = suites.append_child("testsuite");
  Set(suite, "name", fmt::format("{} seed {}", run.scenario, run.seed));
  Set(suite, "tests", std::to_string(counts.tests));
  Set(suite, "failures", std::to_string(counts.failures));
  Set(suite, "errors", std::to_string(counts.errors));
  Set(suite, "skipped", std::to_string(counts.skipped));
  if (run.wall_s) Set(suite, "time", Seconds(*run.wall_s));
  if (!run.file.empty()) Set(suite, "file", run.file);
  AddProperties(suite, run);
  for (const ExpectationResult& e : run.expectations) AddExpectation(suite, run, e);
  AddRun(suite, run);
}

}  // namespace

std::string JunitXml(const std::vector<RunSummary>& runs) {
  Counts total;
  double wall_s = 0;
  for (const RunSummary& run : runs) {
    const Counts counts = Count(run);
    total.tests += counts.tests;
    total.failures += counts.failures;
    total.errors += counts.errors;
    wall_s += run.wall_s.value_or(0);
  }
  pugi::xml_document document;
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  Set(declaration, "version", "1.0");
  Set(declaration, "encoding", "UTF-8");
  pugi::xml_node suites = document.append_child("testsuites");
  Set(suites, "name", "horopter");
  Set(suites, "tests", std::to_string(total.tests));
  Set(suites, "failures", std::to_string(total.failures));
  Set(suites, "errors", std::to_string(total.errors));
  Set(suites, "time", Seconds(wall_s));
  for (const RunSummary& run : runs) AddSuite(suites, run);

  std::ostringstream text;
  document.save(text, "  ", pugi::format_default, pugi::encoding_utf8);
  return text.str();
}

}  // namespace horopter::scenarios
