// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "scenarios/runner/exit_code.h"

namespace horopter::scenarios {

/// What to do with the results that a suite's folder already has.
enum class EarlierResults {
  kRefuse,   ///< they are somebody's: leave them alone
  kResume,   ///< keep the runs that ended with this scenario, stack and build
  kReplace,  ///< remove them
};

/// Tag of scenarios that a folder's runs leave out unless they are asked for by it or by file.
inline constexpr char kOnRequestTag[] = "experiment";

/// What `horopter run` was asked to do.
struct SuiteOptions {
  std::vector<std::filesystem::path> inputs;  ///< scenario files and folders of them
  std::optional<std::string> backend;         ///< instead of each scenario's own
  std::optional<std::string> gl;              ///< likewise
  std::vector<std::uint64_t> seeds;           ///< each scenario with each; empty: its own
  /// Only scenarios with one of them; empty: all but the experiments that a folder holds.
  std::vector<std::string> tags;
  std::filesystem::path out;                  ///< empty: results/run-<date>-<time>
  int jobs = 1;                               ///< runs beside each other
  EarlierResults earlier = EarlierResults::kRefuse;
  std::optional<double> wall_limit_s;  ///< for the whole suite
};

/// Plays scenarios, each run in a process of its own; writes each run's folder, and the suite's
/// summary after every run that ends.
/// @param out the table of expectations and the report's path
/// @param err progress, and what is wrong with the input
/// @return the exit code; an interrupted suite is kInfrastructure
ExitCode RunSuite(const SuiteOptions& options, std::ostream& out, std::ostream& err);

}  // namespace horopter::scenarios
