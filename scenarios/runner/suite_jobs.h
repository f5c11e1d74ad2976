// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "scenarios/format/scenario.h"
#include "scenarios/runner/run_scenario.h"
#include "scenarios/runner/suite.h"

namespace horopter::scenarios {

/// One (scenario, seed) of a suite.
struct SuiteJob {
  Scenario scenario;
  std::filesystem::path folder;
  std::optional<FinishedRun> finished;
  bool kept = false;  ///< finished by an earlier suite
};

/// What a suite is asked to play, in order; their folders are relative to the suite's.
/// @throws ScenarioError with all that is wrong with the files
std::vector<SuiteJob> MakeJobs(const SuiteOptions& options);

}  // namespace horopter::scenarios
