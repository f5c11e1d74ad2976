// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "scenarios/results/results_error.h"
#include "scenarios/results/run_record.h"

namespace horopter::scenarios {

/// Writes summary.json ({"runs": [...]}), junit.xml and report.html (an index with a link to every
/// run's own report) for several runs. May be called again after every run that ends: each file is
/// replaced whole, summary.json last.
/// @param runs in the order to show them, `directory` relative to `folder`; a run that has not
///        ended is listed with the outcome incomplete
/// @throws ResultsError
void WriteSuite(const std::filesystem::path& folder, const std::vector<RunSummary>& runs);

/// Reads summary.json back: of a suite, or of a single run (one element then, its `directory` ".").
/// @param folder_or_file a results folder, or a summary.json itself
/// @throws UnusableResults naming the file and what is wrong with it
std::vector<RunSummary> ReadSuiteSummary(const std::filesystem::path& folder_or_file);

}  // namespace horopter::scenarios
