// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

namespace CLI {
class App;
}

namespace horopter::scenarios {

/// A subcommand: its options are declared on `app`, and `run` does the work once they are parsed,
/// returning the exit code. `run` may throw; the caller turns that into a message and a code.
struct Command {
  CLI::App* app = nullptr;
  std::function<int()> run;
};

Command AddRunCommand(CLI::App& parent);
Command AddListCommand(CLI::App& parent);
Command AddValidateCommand(CLI::App& parent);
Command AddCompareCommand(CLI::App& parent);
Command AddDisparityCommand(CLI::App& parent);
Command AddDoctorCommand(CLI::App& parent);
/// @param command_line that the program was called with, for the data set's manifest
Command AddRenderCommand(CLI::App& parent, const std::string& command_line);
Command AddSchemaCommand(CLI::App& parent);
Command AddScoreCommand(CLI::App& parent);
Command AddTimingCommand(CLI::App& parent);

}  // namespace horopter::scenarios
