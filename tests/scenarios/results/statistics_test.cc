// SPDX-License-Identifier: Apache-2.0
#include "scenarios/results/statistics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace horopter::scenarios {
namespace {

TEST(Quantile, InterpolatesBetweenOrderStatistics) {
  EXPECT_DOUBLE_EQ(*Median({3, 1, 2}), 2);
  EXPECT_DOUBLE_EQ(*Median({4, 1, 2, 3}), 2.5);
  // numpy.percentile([1, 2, 3, 4, 10], 95) is 8.8.
  EXPECT_DOUBLE_EQ(*Percentile95({10, 4, 3, 2, 1}), 8.8);
  EXPECT_DOUBLE_EQ(*Quantile({5, 7}, 0), 5);
  EXPECT_DOUBLE_EQ(*Quantile({5, 7}, 1), 7);
  EXPECT_DOUBLE_EQ(*Percentile95({42}), 42);
}

TEST(Quantile, HasNoValueWithoutASample) {
  EXPECT_FALSE(Median({}));
  EXPECT_FALSE(Median({std::nan("")}));
  EXPECT_DOUBLE_EQ(*Median({std::nan(""), 3}), 3);
}

TEST(Summarise, GivesEachStageItsOwnNumbers) {
  hardware::StageTimes times;
  for (int i = 1; i <= 21; ++i) times.Add("render", i);
  times.Add("physics", 0.5);
  const auto summary = Summarise(times);
  ASSERT_EQ(summary.size(), 2u);
  EXPECT_DOUBLE_EQ(summary.at("render").median_ms.value(), 11);
  EXPECT_DOUBLE_EQ(summary.at("render").p95_ms.value(), 20);
  EXPECT_EQ(summary.at("render").n, 21);
  EXPECT_EQ(summary.at("physics").n, 1);
}

}  // namespace
}  // namespace horopter::scenarios
