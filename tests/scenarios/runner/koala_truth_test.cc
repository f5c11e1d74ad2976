// SPDX-License-Identifier: Apache-2.0
#include "scenarios/runner/koala_truth.h"

#include <gtest/gtest.h>

#include <cmath>

namespace horopter::scenarios {
namespace {

TEST(WorseEye, IsTheLargerErrorAndNoneWhereAnEyeHasNone) {
  EXPECT_EQ(WorseEye(0.1, 0.3), 0.3);
  EXPECT_EQ(WorseEye(0.3, 0.1), 0.3);
  EXPECT_TRUE(std::isnan(WorseEye(std::nan(""), 0.1)));
  EXPECT_TRUE(std::isnan(WorseEye(0.1, std::nan(""))));
}

}  // namespace
}  // namespace horopter::scenarios
