// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "scenarios/cli/commands.h"
#include "scenarios/format/find_scenarios.h"
#include "scenarios/format/scenario_format.h"
#include "scenarios/format/scenes.h"
#include "scenarios/runner/exit_code.h"

namespace horopter::scenarios {
namespace {

int Validate(const std::vector<std::string>& inputs) {
  bool all_good = true;
  for (const auto& file : FindScenarios({inputs.begin(), inputs.end()})) {
    try {
      ParseScenario(file, {ScenesDir()});
      std::cout << file.string() << ": ok\n";
    } catch (const ScenarioError& error) {
      std::cerr << error.what() << "\n";
      all_good = false;
    }
  }
  return static_cast<int>(all_good ? ExitCode::kPassed : ExitCode::kBadInput);
}

}  // namespace

Command AddValidateCommand(CLI::App& parent) {
  CLI::App* app = parent.add_subcommand("validate", "Check scenario files without playing them");
  // Shared by CLI11, which writes into it while parsing, and the closure that runs afterwards.
  const auto inputs = std::make_shared<std::vector<std::string>>();
  app->add_option("FILE", *inputs, "Scenario files, and folders of them")->required();
  app->footer("\nExample:\n  horopter validate scenarios/koala/first_waypoint.yaml");
  return {app, [inputs] { return Validate(*inputs); }};
}

}  // namespace horopter::scenarios
