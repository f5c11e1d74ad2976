// SPDX-License-Identifier: Apache-2.0
#include "sim/random/random_stream.h"

#include <gtest/gtest.h>

#include <cmath>

namespace horopter::sim {
namespace {

TEST(RandomStream, SameSeedAndNameGiveTheSameNumbers) {
  RandomStream a(7, "camera.left.noise"), b(7, "camera.left.noise");
  for (int i = 0; i < 100; ++i) EXPECT_EQ(a.Next(), b.Next());
}

TEST(RandomStream, SeedAndNameEachMakeAnotherStream) {
  RandomStream base(7, "camera.left"), seed(8, "camera.left"), name(7, "camera.right");
  int equal = 0;
  for (int i = 0; i < 1000; ++i) {
    const auto x = base.Next();
    equal += (x == seed.Next()) + (x == name.Next());
  }
  EXPECT_EQ(equal, 0);
}

TEST(RandomStream, UniformFillsItsRangeEvenly) {
  RandomStream stream(1, "uniform");
  constexpr int kDraws = 100000, kBins = 10;
  int bins[kBins] = {};
  for (int i = 0; i < kDraws; ++i) {
    const double x = stream.Uniform(-2, 3);
    ASSERT_GE(x, -2);
    ASSERT_LT(x, 3);
    ++bins[static_cast<int>((x + 2) / 5 * kBins)];
  }
  // Five standard deviations of a binomial count.
  for (const int count : bins) EXPECT_NEAR(count, kDraws / kBins, 5 * std::sqrt(9000.0));
}

TEST(RandomStream, GaussianHasUnitMoments) {
  RandomStream stream(1, "gaussian");
  constexpr int kDraws = 200000;
  double sum = 0, square = 0, fourth = 0;
  for (int i = 0; i < kDraws; ++i) {
    const double x = stream.Gaussian();
    sum += x;
    square += x * x;
    fourth += x * x * x * x;
  }
  EXPECT_NEAR(sum / kDraws, 0, 5 / std::sqrt(kDraws));
  EXPECT_NEAR(square / kDraws, 1, 5 * std::sqrt(2.0 / kDraws));
  EXPECT_NEAR(fourth / kDraws, 3, 5 * std::sqrt(96.0 / kDraws));
}

}  // namespace
}  // namespace horopter::sim
