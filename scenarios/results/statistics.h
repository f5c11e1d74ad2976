// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hardware/types/stage_times.h"
#include "scenarios/results/run_record.h"

namespace horopter::scenarios {

/// The value below which a fraction of the sample lies, interpolated linearly between order
/// statistics at (n - 1) * fraction (Hyndman and Fan 1996, type 7, as NumPy's and R's default).
/// NaNs are not part of the sample. @param fraction in [0, 1]
/// @return nothing for an empty sample
std::optional<double> Quantile(std::vector<double> sample, double fraction);

inline std::optional<double> Median(std::vector<double> sample) {
  return Quantile(std::move(sample), 0.5);
}
inline std::optional<double> Percentile95(std::vector<double> sample) {
  return Quantile(std::move(sample), 0.95);
}

/// Median and 95th percentile of every stage that ran at least once.
std::map<std::string, StageTiming> Summarise(const hardware::StageTimes& times);

}  // namespace horopter::scenarios
