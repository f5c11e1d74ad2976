// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "scenarios/results/run_record.h"

namespace horopter::scenarios {

/// Index of several runs as one HTML page: how many passed, then every run with a link to its own
/// report, and below it what was not met.
std::string SuiteReportHtml(const std::vector<RunSummary>& runs);

}  // namespace horopter::scenarios
