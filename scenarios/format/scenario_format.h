// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "scenarios/format/diagnostics.h"
#include "scenarios/format/scenario.h"

namespace horopter::scenarios {

struct ParseOptions {
  /// Where scenes and robots are looked up. Empty: a scenario's scene and robot are not looked up,
  /// and nothing is held against the robot's limits.
  std::filesystem::path scenes_dir;
};

/// Reads and checks a scenario file.
/// @throws ScenarioError with everything that is wrong with it, or that it cannot be read
Scenario ParseScenario(const std::filesystem::path& path, const ParseOptions& options);

/// The same for a text. @param name how messages name it, and `Scenario::file`; its stem is the
/// default of the scenario's own name.
Scenario ParseScenarioText(const std::string& text, const std::string& name,
                           const ParseOptions& options = {});

/// The scenario with every default filled in, as a file that parses to an equal scenario.
std::string ResolvedYaml(const Scenario& scenario);

/// JSON Schema (draft 7) of scenario files. What it accepts and the parser refuses is what needs
/// more than one value to see: scenes and robots that do not exist, targets out of sight, steps
/// that an expectation lacks, limits that no metric reaches.
nlohmann::json ScenarioSchema();

}  // namespace horopter::scenarios
