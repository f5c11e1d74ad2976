// SPDX-License-Identifier: Apache-2.0
#include "scenarios/cli/paired_noise.h"

#include <gtest/gtest.h>

#include <cmath>

namespace horopter::scenarios {
namespace {

TEST(MedianNoise, IsThreeStandardErrorsOfTheMedian) {
  // Deviations from the median 3: 2 1 0 1 2, so MAD 1.
  EXPECT_NEAR(MedianNoise({1, 2, 3, 4, 5}), 3 * 1.2533 * 1.4826 / std::sqrt(5.0), 1e-12);
  EXPECT_NEAR(MedianNoise({1, 2, 3, 4, 5000}), MedianNoise({1, 2, 3, 4, 5}), 1e-12);
}

TEST(PairNoise, AddsTheVariancesOfTheOtherPairsAndTheOldRuns) {
  const double sigma = 1.4826;
  EXPECT_NEAR(PairNoise({1, 2, 3, 4, 5}, {7, 7, 7}), 3.5 * sigma, 1e-12);
  EXPECT_NEAR(PairNoise({0, 0, 0}, {1, 2, 3, 4, 5}), 3.5 * sigma, 1e-12);
  EXPECT_NEAR(PairNoise({1, 2, 3, 4, 5}, {1, 2, 3, 4, 5}), 3.5 * std::sqrt(2.0) * sigma, 1e-12);
}

TEST(PairedNoise, IsUnknownBelowThreeValues) {
  EXPECT_EQ(MedianNoise({}), 0);
  EXPECT_EQ(MedianNoise({1, 2}), 0);
  EXPECT_EQ(PairNoise({}, {1}), 0);
  EXPECT_EQ(PairNoise({1, 9}, {1, 9}), 0);
}

}  // namespace
}  // namespace horopter::scenarios
