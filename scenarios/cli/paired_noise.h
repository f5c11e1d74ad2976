// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace horopter::scenarios {

/// Runs from which on a spread can be estimated; below, noise is known by its floor alone.
constexpr std::size_t kRunsForSpread = 3;

/// Median of a sample, 0 of an empty one.
double MedianOf(std::vector<double> sample);

/// How far the median of paired differences may lie from 0 by chance: three of its standard
/// errors, 1.2533 sigma / sqrt(n), with sigma estimated robustly as 1.4826 MAD.
/// @return 0 below kRunsForSpread differences
double MedianNoise(const std::vector<double>& differences);

/// How far a single pair, the worst of its suite, may lie from 0 by chance: 3.5 sigma, the limit of
/// Iglewicz and Hoaglin (1993) for outliers by MAD. The variance is that of the other pairs'
/// differences plus that of the old values: a harmless change of the code can reshuffle which seed
/// meets which fate, and the others' differences alone are too few to tell (of five pairs of pure
/// noise, a quarter would be called worse; with the old spread one in fifteen, of ten one in fifty,
/// and none where the pairs go together).
/// @param others the differences of all pairs but the one judged
/// @param olds the old values of all pairs
/// @return of each part 0 below kRunsForSpread values
double PairNoise(const std::vector<double>& others, const std::vector<double>& olds);

}  // namespace horopter::scenarios
