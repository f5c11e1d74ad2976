// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "scenarios/format/scenario.h"
#include "scenarios/results/run_record.h"
#include "scenarios/runner/exit_code.h"
#include "scenarios/runner/session.h"

namespace horopter::scenarios {

/// A run that has ended, however it did.
struct FinishedRun {
  RunSummary summary;
  ExitCode exit_code = ExitCode::kPassed;
};

/// What is known of a run before it starts; its outcome is incomplete.
RunSummary IdentityOf(const Scenario& scenario);

/// Plays one scenario with its seed and writes the run's folder. Whatever goes wrong inside ends in
/// the summary as an error; only a folder that cannot be written throws.
/// @throws ResultsError
FinishedRun RunScenario(const Scenario& scenario, const std::filesystem::path& folder,
                        const RunHooks& hooks);

}  // namespace horopter::scenarios
