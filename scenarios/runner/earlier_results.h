// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <ostream>
#include <vector>

#include "scenarios/runner/suite.h"
#include "scenarios/runner/suite_jobs.h"

namespace horopter::scenarios {

/// Deals with the results that a suite's folder already has, if any, before the suite writes there.
///
/// kReplace removes the folders of the runs that its summary names. kResume finishes the jobs whose
/// runs ended there with the same resolved scenario, stack
/// record and versions, and says on `err` how
/// many it does not because another build made them.
/// @throws UnusableResults when there are results and they were to be refused, or when resuming
///         would leave runs behind that no job asks for
void TakeOver(const std::filesystem::path& folder, EarlierResults what, std::vector<SuiteJob>& jobs,
              std::ostream& err);

}  // namespace horopter::scenarios
