// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "accuracy_runs.h"

namespace horopter::vision::testing {

/// Accuracy against time as SVG: milliseconds to the right and the share of estimates off by more
/// than 2 px upwards, both logarithmic, so that better is left and below; the area of a dot is the
/// density.
std::string AccuracyPlot(const std::string& title, const std::vector<MethodResult>& results);

}  // namespace horopter::vision::testing
