// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "scenarios/cli/compare.h"

namespace horopter::scenarios {

/// The comparison as text for a terminal, regressions first within each part. Rows without a
/// change are counted, not listed, unless `all`.
std::string CompareTable(const SuiteComparison& comparison, bool all);

}  // namespace horopter::scenarios
