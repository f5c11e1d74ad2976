// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "scenarios/cli/commands.h"
#include "scenarios/format/find_scenarios.h"
#include "scenarios/format/scenario_format.h"
#include "scenarios/format/scenes.h"
#include "scenarios/runner/behaviour.h"
#include "scenarios/runner/exit_code.h"

namespace horopter::scenarios {
namespace {

struct ListArguments {
  std::vector<std::string> inputs;
  bool json = false;
};

std::vector<std::string> StepNames(const Scenario& scenario) {
  std::vector<std::string> names;
  for (const Step& step : scenario.steps) names.push_back(StepName(step.action));
  return names;
}

nlohmann::ordered_json ToJson(const Scenario& s) {
  std::vector<std::string> expectations;
  for (const Expectation& e : s.expect) expectations.push_back(e.text);
  return {{"file", s.file.string()}, {"name", s.name},        {"description", s.description},
          {"tags", s.tags},          {"backend", s.backend},  {"scene", s.scene},
          {"robot", s.robot},        {"steps", StepNames(s)}, {"expect", expectations}};
}

void Print(const Scenario& s) {
  fmt::print("{}\n  {}  [{}]\n", s.file.string(), s.name, fmt::join(s.tags, ", "));
  std::string description = s.description;
  while (description.ends_with('\n')) description.pop_back();
  if (!description.empty()) fmt::print("  {}\n", description);
  fmt::print("  steps: {}; {} expectations\n", fmt::join(StepNames(s), ", "), s.expect.size());
}

int List(const ListArguments& arguments) {
  std::vector<std::filesystem::path> inputs(arguments.inputs.begin(), arguments.inputs.end());
  if (inputs.empty()) inputs.emplace_back(HOROPTER_SCENARIOS_DIR);
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  bool all_good = true;
  for (const auto& file : FindScenarios(inputs)) {
    try {
      const Scenario scenario = ParseScenario(file, {ScenesDir()});
      if (arguments.json) {
        list.push_back(ToJson(scenario));
      } else {
        Print(scenario);
      }
    } catch (const ScenarioError& error) {
      std::cerr << error.what() << "\n";
      all_good = false;
    }
  }
  if (arguments.json) std::cout << list.dump(2) << "\n";
  return static_cast<int>(all_good ? ExitCode::kPassed : ExitCode::kBadInput);
}

}  // namespace

Command AddListCommand(CLI::App& parent) {
  CLI::App* app = parent.add_subcommand("list", "Show scenarios: name, tags, what they do");
  // Shared by CLI11, which writes into it while parsing, and the closure that runs afterwards.
  const auto a = std::make_shared<ListArguments>();
  app->add_option("DIR", a->inputs, "Scenario files, and folders of them [the shipped ones]");
  app->add_flag("--json", a->json, "As JSON");
  app->footer("\nExample:\n  horopter list scenarios/koala --json");
  return {app, [a] { return List(*a); }};
}

}  // namespace horopter::scenarios
