// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scenarios/cli/commands.h"
#include "scenarios/results/statistics.h"
#include "scenarios/results/suite.h"
#include "scenarios/runner/exit_code.h"

namespace horopter::scenarios {
namespace {

/// One stage over several runs.
struct StageOverRuns {
  std::vector<double> medians_ms;
  std::optional<double> worst_p95_ms;
  int passes = 0;
};

std::map<std::string, StageOverRuns> Gather(const std::vector<RunSummary>& runs) {
  std::map<std::string, StageOverRuns> stages;
  for (const RunSummary& run : runs) {
    for (const auto& [name, timing] : run.timing_ms) {
      StageOverRuns& stage = stages[name];
      if (timing.median_ms) stage.medians_ms.push_back(*timing.median_ms);
      stage.worst_p95_ms = std::max(stage.worst_p95_ms, timing.p95_ms);  // nothing is the least
      stage.passes += timing.n;
    }
  }
  return stages;
}

std::string Cell(std::optional<double> ms) { return ms ? fmt::format("{:.3f}", *ms) : "-"; }

/// "Intel Xeon, 2 cores; load when the runs began 0.10 to 1.92", a line per machine.
void PrintMachines(const std::vector<RunSummary>& runs) {
  std::map<std::string, std::vector<double>> loads;
  for (const RunSummary& run : runs) {
    std::vector<double>& of_machine = loads[DescribeMachine(run.machine)];
    if (run.machine.load) of_machine.push_back(*run.machine.load);
  }
  for (const auto& [machine, load] : loads) {
    std::cout << machine;
    if (!load.empty()) {
      const auto [least, most] = std::minmax_element(load.begin(), load.end());
      std::cout << fmt::format("; load when the runs began {:.2f} to {:.2f}", *least, *most);
    }
    std::cout << '\n';
  }
  std::cout << '\n';
}

void PrintMarkdown(const std::vector<RunSummary>& runs) {
  std::cout << "| stage | median ms | worst run's 95 % ms | passes |\n|---|---:|---:|---:|\n";
  for (const auto& [name, stage] : Gather(runs)) {
    std::cout << fmt::format("| {} | {} | {} | {} |\n", name, Cell(Median(stage.medians_ms)),
                             Cell(stage.worst_p95_ms), stage.passes);
  }
}

}  // namespace

Command AddTimingCommand(CLI::App& parent) {
  CLI::App* app = parent.add_subcommand("timing", "Print milliseconds per stage as Markdown");
  // Shared by CLI11, which writes into it while parsing, and the closure that runs afterwards.
  const auto folder = std::make_shared<std::string>();
  app->add_option("RESULTS", *folder, "Results folder of one run or several")->required();
  app->footer(
      "\nThe machines that the runs were played on, and how busy they were; the median over the\n"
      "runs' medians, and the worst of their 95th percentiles.\n"
      "\nExample:\n"
      "  horopter run scenarios/ --out results/timing\n"
      "  horopter timing results/timing");
  return {app, [folder] {
            const std::vector<RunSummary> runs = ReadSuiteSummary(*folder);
            PrintMachines(runs);
            PrintMarkdown(runs);
            return static_cast<int>(ExitCode::kPassed);
          }};
}

}  // namespace horopter::scenarios
