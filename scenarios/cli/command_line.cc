// SPDX-License-Identifier: Apache-2.0
#include "scenarios/cli/command_line.h"

#include <CLI/CLI.hpp>

#include <exception>
#include <iostream>
#include <regex>
#include <stdexcept>
#include <string>
#include <vector>

#include "scenarios/cli/commands.h"
#include "scenarios/dataset/format_error.h"
#include "scenarios/format/diagnostics.h"
#include "scenarios/format/suggest.h"
#include "scenarios/runner/exit_code.h"
#include "scenarios/runner/versions.h"

namespace horopter::scenarios {
namespace {

constexpr int kUsage = static_cast<int>(ExitCode::kBadInput);

constexpr const char* kFooter =
    "\nExamples:\n"
    "  horopter run scenarios/ --seeds 1-5\n"
    "  horopter validate scenarios/koala/first_waypoint.yaml\n"
    "  horopter compare results/before results/after\n"
    "  horopter render koala/room.xml --random 20 --truth --out dataset\n"
    "  horopter disparity left.png right.png --out disparity.flo\n"
    "\nExit codes: 0 all passed; 1 an expectation failed, or a regression; 2 bad input or usage;\n"
    "3 infrastructure (no GL, disk full); 4 hardware unavailable.";

std::vector<std::string> OptionNames(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

std::vector<std::string> SubcommandNames(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; })) {
    names.push_back(sub->get_name());
  }
  return names;
}

/// What is wrong with words that no option or subcommand took.
std::string Unexpected(const CLI::App& app, const CLI::App& chosen) {
  const std::vector<std::string> rest = app.remaining(true);
  if (rest.empty()) return "unexpected arguments";
  const std::string& word = rest.front();
  if (word.starts_with('-')) {
    const std::string name = word.substr(0, word.find('='));
    return "unknown option '" + name + "'" + DidYouMean(name, OptionNames(chosen));
  }
  if (&chosen == &app) {
    return "unknown command '" + word + "'" + DidYouMean(word, SubcommandNames(app));
  }
  return "unexpected argument '" + word + "'";
}

int ExplainUsage(const CLI::App& app, const CLI::ParseError& error) {
  const auto parsed = app.get_subcommands();
  const CLI::App& chosen = parsed.empty() ? app : *parsed.front();
  const bool extras = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr;
  const std::string help = parsed.empty() ? "" : " " + chosen.get_name();
  std::cerr << "horopter" << help << ": " << (extras ? Unexpected(app, chosen) : error.what())
            << " (see horopter" << help << " --help)\n";
  return kUsage;
}

/// The call as a shell would take it again.
std::string CommandLine(int argc, const char* const* argv) {
  static const std::regex plain("[A-Za-z0-9_./:=,+-]+");
  std::string line = "horopter";
  for (int i = 1; i < argc; ++i) {
    std::string word = argv[i];
    if (!std::regex_match(word, plain)) {
      word = "'" + std::regex_replace(word, std::regex("'"), R"('\'')") + "'";
    }
    line += " " + word;
  }
  return line;
}

int Execute(const std::vector<Command>& commands) {
  for (const Command& command : commands) {
    if (!command.app->parsed()) continue;
    try {
      return command.run();
    } catch (const std::invalid_argument& error) {
      std::cerr << "horopter " << command.app->get_name() << ": " << error.what() << "\n";
      return kUsage;
    } catch (const FormatError& error) {
      std::cerr << "horopter " << command.app->get_name() << ": " << error.what() << "\n";
      return kUsage;
    } catch (const ScenarioError& error) {  // one line each, with its own place
      std::cerr << error.what() << "\n";
      return kUsage;
    } catch (const std::exception& error) {
      std::cerr << "horopter " << command.app->get_name() << ": " << error.what() << "\n";
      return static_cast<int>(ExitCodeOf(error));
    }
  }
  return kUsage;
}

}  // namespace

int RunCommandLine(int argc, const char* const* argv) {
  CLI::App app{
      "Plays scripted navigation and fixation scenarios on a virtual or real stereo head "
      "and says how wrong the vision was."};
  app.name("horopter");
  app.set_version_flag("--version", "horopter " + Version());
  app.footer(kFooter);
  app.require_subcommand(0, 1);
  const std::vector<Command> commands = {AddRunCommand(app),
                                         AddListCommand(app),
                                         AddValidateCommand(app),
                                         AddCompareCommand(app),
                                         AddRenderCommand(app, CommandLine(argc, argv)),
                                         AddDisparityCommand(app),
                                         AddScoreCommand(app),
                                         AddDoctorCommand(app),
                                         AddSchemaCommand(app),
                                         AddTimingCommand(app)};
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {
    return app.exit(success);  // --help, --version
  } catch (const CLI::ParseError& error) {
    return ExplainUsage(app, error);
  }
  if (app.get_subcommands().empty()) {
    std::cerr << app.help();
    return kUsage;
  }
  return Execute(commands);
}

}  // namespace horopter::scenarios
