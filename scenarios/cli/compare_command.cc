// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "scenarios/cli/commands.h"
#include "scenarios/cli/compare.h"
#include "scenarios/cli/compare_table.h"
#include "scenarios/results/suite.h"
#include "scenarios/runner/exit_code.h"

namespace horopter::scenarios {
namespace {

struct CompareArguments {
  std::string before;
  std::string after;
  bool timings = false;
  bool allow_missing = false;
  bool all = false;
};

int CompareFolders(const CompareArguments& a) {
  const SuiteComparison comparison = Compare(ReadSuiteSummary(a.before), ReadSuiteSummary(a.after));
  std::cout << CompareTable(comparison, a.all);
  if (comparison.pairs == 0) {
    std::cerr << "horopter compare: the folders have no run in common (scenario, seed and backend "
                 "must agree)\n";
    return static_cast<int>(ExitCode::kBadInput);
  }
  const bool lost = !a.allow_missing && !comparison.missing.empty();
  const bool regressed = comparison.OutcomesOrMetricsRegressed() || lost ||
                         (a.timings && comparison.TimingsRegressed());
  if (lost)
    std::cout << "What only the old results have counts as lost; --allow-missing lets it.\n";
  std::cout << (regressed ? "Regressed.\n" : "No regression.\n");
  return static_cast<int>(regressed ? ExitCode::kExpectationFailed : ExitCode::kPassed);
}

}  // namespace

Command AddCompareCommand(CLI::App& parent) {
  CLI::App* app =
      parent.add_subcommand("compare", "Hold new results against old ones; exit 1 on a regression");
  // Shared by CLI11, which writes into it while parsing, and the closure that runs afterwards.
  const auto a = std::make_shared<CompareArguments>();
  app->add_option("OLD", a->before, "Results folder to compare with")->required();
  app->add_option("NEW", a->after, "Results folder to judge")->required();
  app->add_flag("--timings", a->timings, "A stage that became slower is a regression too");
  app->add_flag("--allow-missing", a->allow_missing,
                "Runs, expectations and metrics that NEW lacks are no regression");
  app->add_flag("--all", a->all, "List what did not change, too");
  app->footer(
      "\nA run or expectation that ends worse than before is a regression. So is a metric whose\n"
      "median over the seeds worsened beyond three standard errors of the paired differences (at\n"
      "least 1 % of the old median, 10 % below three seeds), or whose worst seed worsened beyond\n"
      "3.5 sigma of the other seeds' differences and of the old runs together (at least 10 %).\n"
      "Spreads are robust (MAD).\n"
      "\nExample:\n  horopter compare results/main results/branch --timings");
  return {app, [a] { return CompareFolders(*a); }};
}

}  // namespace horopter::scenarios
