// SPDX-License-Identifier: Apache-2.0
#include "vision/regions/nearest_rank.h"

#include <gtest/gtest.h>

namespace horopter::vision {
namespace {

TEST(NearestRank, IsTheValueThatSoManyAreBelow) {
  std::vector<float> values{9, 3, 7, 1, 5};
  EXPECT_EQ(NearestRank(values, 0), 1);
  EXPECT_EQ(NearestRank(values, 0.19), 1);
  EXPECT_EQ(NearestRank(values, 0.2), 3);
  EXPECT_EQ(NearestRank(values, 0.999), 9);
}

TEST(NearestRank, OfOneValueIsThatValue) {
  std::vector<float> values{4};
  EXPECT_EQ(NearestRank(values, 0.95), 4);
}

}  // namespace
}  // namespace horopter::vision
