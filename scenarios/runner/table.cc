// SPDX-License-Identifier: Apache-2.0
#include "scenarios/runner/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

namespace horopter::scenarios {
namespace {

constexpr std::size_t kColumns = 5;
using Row = std::array<std::string, kColumns>;

std::string Mark(ExpectationOutcome outcome) {
  switch (outcome) {
    case ExpectationOutcome::kPassed:
      return "pass";
    case ExpectationOutcome::kFailed:
      return "FAIL";
    case ExpectationOutcome::kNotApplicable:
      return "not applicable";
  }
  return "";
}

std::string WithUnit(double value, const std::string& unit) {
  return unit.empty() ? fmt::format("{:.4g}", value) : fmt::format("{:.4g} {}", value, unit);
}

void AddRun(const RunSummary& run, std::vector<Row>& rows) {
  const std::string name = fmt::format("{} seed {}", run.scenario, run.seed);
  if (run.expectations.empty()) {
    rows.push_back({name, "", "", "", ToString(run.outcome)});
  }
  for (const ExpectationResult& e : run.expectations) {
    const bool first = &e == &run.expectations.front();
    rows.push_back({first ? name : "", e.name, e.value ? WithUnit(*e.value, e.unit) : "-",
                    WithUnit(e.limit, e.unit), Mark(e.outcome)});
    if (!e.detail.empty()) rows.back().back() += ": " + e.detail;
  }
  if (!run.error.empty())
    rows.push_back({"", "", "", "", ToString(run.outcome) + ": " + run.error});
}

}  // namespace

void PrintTable(const std::vector<RunSummary>& runs, std::ostream& out) {
  std::vector<Row> rows = {{"run", "expectation", "value", "limit", "result"}};
  for (const RunSummary& run : runs) AddRun(run, rows);
  std::array<std::size_t, kColumns> width{};
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < kColumns; ++i) width[i] = std::max(width[i], row[i].size());
  }
  for (const Row& row : rows) {
    out << fmt::format("{:{}}  {:{}}  {:>{}}  {:>{}}  {}\n", row[0], width[0], row[1], width[1],
                       row[2], width[2], row[3], width[3], row[4]);
  }
}

}  // namespace horopter::scenarios
