// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <vector>

#include "scenarios/results/run_record.h"

namespace horopter::scenarios {

/// Every expectation of every run with its value, limit and outcome, in aligned columns.
void PrintTable(const std::vector<RunSummary>& runs, std::ostream& out);

}  // namespace horopter::scenarios
