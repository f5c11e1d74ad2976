// SPDX-License-Identifier: Apache-2.0
#include "scenarios/results/statistics.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace horopter::scenarios {

std::optional<double> Quantile(std::vector<double> sample, double fraction) {
  assert(fraction >= 0 && fraction <= 1);
  std::erase_if(sample, [](double x) { return std::isnan(x); });
  if (sample.empty()) return std::nullopt;
  std::sort(sample.begin(), sample.end());
  const double position = static_cast<double>(sample.size() - 1) * fraction;
  const auto below = static_cast<std::size_t>(position);
  const std::size_t above = std::min(below + 1, sample.size() - 1);
  return std::lerp(sample[below], sample[above], position - static_cast<double>(below));
}

std::map<std::string, StageTiming> Summarise(const hardware::StageTimes& times) {
  std::map<std::string, StageTiming> summary;
  for (const auto& [stage, samples] : times.samples()) {
    const std::optional<double> median = Median(samples);
    if (!median) continue;
    summary[stage] = {*median, *Percentile95(samples), static_cast<int>(samples.size())};
  }
  return summary;
}

}  // namespace horopter::scenarios
