// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "scenarios/cli/commands.h"
#include "scenarios/format/robot_description.h"
#include "scenarios/format/scenario_format.h"
#include "scenarios/runner/exit_code.h"

namespace horopter::scenarios {

Command AddSchemaCommand(CLI::App& parent) {
  CLI::App* app = parent.add_subcommand("schema", "Print the JSON Schema of scenario files");
  // Shared by CLI11, which writes into it while parsing, and the closure that runs afterwards.
  const auto robot = std::make_shared<bool>(false);
  app->add_flag("--robot", *robot, "Of robot.yaml instead");
  app->footer("\nExample:\n  horopter schema > scenarios/schema/scenario.schema.json");
  return {app, [robot] {
            std::cout << (*robot ? RobotSchema() : ScenarioSchema()).dump(2) << "\n";
            return static_cast<int>(ExitCode::kPassed);
          }};
}

}  // namespace horopter::scenarios
