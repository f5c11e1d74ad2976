// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "scenarios/results/run_record.h"

namespace horopter::scenarios {

/// Keys in a fixed order and numbers in a form that reads back as the same double, so that two
/// equal runs give equal text but for timing_ms and wall_s. What never had a value is null.
nlohmann::ordered_json ToJson(const RunSummary& run);
nlohmann::ordered_json ToJson(const PlanRecord& plan);

/// Text of a single run's summary.json, and of a suite's ({"runs": [...]}).
std::string RunSummaryText(const RunSummary& run);
std::string SuiteSummaryText(const std::vector<RunSummary>& runs);

/// Reads either text. Unknown keys are passed over, so that a newer summary can be compared with an
/// older one; a missing or ill-typed one of the required (scenario, seed, backend, outcome,
/// expectations) is an error.
/// @throws ResultsError with the place inside the text ("runs[2].seed: ...")
std::vector<RunSummary> ParseSummaryText(std::string_view text);

}  // namespace horopter::scenarios
