// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "scenarios/results/run_record.h"

namespace horopter::scenarios {

/// A sentence for every stage of every scenario that took longer on this machine, at its 95th
/// percentile, than the simulation lets it take: the robot had its results sooner than it would
/// have had them here. Of several runs the slowest is named. By the wall clock, so it is told to
/// people and judges nothing.
std::vector<std::string> TimingNotices(const std::vector<RunSummary>& runs);

}  // namespace horopter::scenarios
