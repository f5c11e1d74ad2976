// SPDX-License-Identifier: Apache-2.0
#include "hardware/types/result.h"

#include <gtest/gtest.h>

#include <memory>

namespace horopter::hardware {
namespace {

Result<int> Half(int n) {
  if (n % 2 != 0) return Error{ErrorCode::kOutOfRange, "odd"};
  return n / 2;
}

TEST(Result, HoldsAValueOrAnError) {
  ASSERT_TRUE(Half(4).ok());
  EXPECT_EQ(*Half(4), 2);
  const Result<int> odd = Half(3);
  ASSERT_FALSE(odd);
  EXPECT_EQ(odd.error().code, ErrorCode::kOutOfRange);
  EXPECT_EQ(odd.error().message, "odd");
}

TEST(Result, OfNothingIsSuccessUnlessAnErrorIsGiven) {
  const Result<void> good;
  const Result<void> bad = Error{ErrorCode::kTimeout, "late"};
  EXPECT_TRUE(good.ok());
  ASSERT_FALSE(bad.ok());
  EXPECT_EQ(bad.error().code, ErrorCode::kTimeout);
}

TEST(Result, ATemporaryGivesItsValueAway) {
  const auto make = []() -> Result<std::unique_ptr<int>> { return std::make_unique<int>(7); };
  const std::unique_ptr<int> taken = *make();
  EXPECT_EQ(*taken, 7);
  EXPECT_EQ(*make().value(), 7);
}

}  // namespace
}  // namespace horopter::hardware
