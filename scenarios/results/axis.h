// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace horopter::scenarios {

/// Smallest round step (1, 2 or 5 times a power of ten) that gives at most `most` intervals over a
/// span, so that an axis' numbers are easy to read. A span that is not positive counts as 1.
double NiceStep(double span, int most);

/// Multiples of the step within [low, high].
std::vector<double> Ticks(double low, double high, double step);

/// A tick's number with as many decimals as its step needs.
std::string TickText(double value, double step);

}  // namespace horopter::scenarios
