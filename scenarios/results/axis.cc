// SPDX-License-Identifier: Apache-2.0
#include "scenarios/results/axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace horopter::scenarios {

double NiceStep(double span, int most) {
  if (!(span > 0) || !std::isfinite(span)) span = 1;
  const double least = span / most;
  const double power = std::pow(10, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= least * (1 - 1e-9)) return factor * power;
  }
  return 10 * power;
}

std::vector<double> Ticks(double low, double high, double step) {
  std::vector<double> ticks;
  const double slack = 1e-6 * step;
  for (double n = std::ceil((low - slack) / step); n * step <= high + slack; ++n) {
    ticks.push_back(n * step);
  }
  return ticks;
}

std::string TickText(double value, double step) {
  const int decimals = std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
  const double clean = std::abs(value) < 1e-6 * step ? 0 : value;
  return fmt::format("{:.{}f}", clean, decimals);
}

}  // namespace horopter::scenarios
