// SPDX-License-Identifier: Apache-2.0
#include "scenarios/cli/paired_noise.h"

#include <cmath>
#include <utility>

#include "scenarios/results/statistics.h"

namespace horopter::scenarios {
namespace {

constexpr double kMadToSigma = 1.4826;      // of a normal distribution
constexpr double kMedianStdError = 1.2533;  // sqrt(pi / 2)
constexpr double kStdErrors = 3;
constexpr double kPairSigmas = 3.5;

/// 0 where the spread cannot be known.
double RobustSigma(const std::vector<double>& sample) {
  if (sample.size() < kRunsForSpread) return 0;
  const double centre = MedianOf(sample);
  std::vector<double> deviations;
  for (double value : sample) deviations.push_back(std::abs(value - centre));
  return kMadToSigma * MedianOf(std::move(deviations));
}

}  // namespace

double MedianOf(std::vector<double> sample) { return Median(std::move(sample)).value_or(0); }

double MedianNoise(const std::vector<double>& differences) {
  if (differences.empty()) return 0;
  return kStdErrors * kMedianStdError * RobustSigma(differences) /
         std::sqrt(static_cast<double>(differences.size()));
}

double PairNoise(const std::vector<double>& others, const std::vector<double>& olds) {
  return kPairSigmas * std::hypot(RobustSigma(others), RobustSigma(olds));
}

}  // namespace horopter::scenarios
