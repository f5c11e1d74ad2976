// SPDX-License-Identifier: Apache-2.0
#include "hardware/types/field_checker.h"

#include <gtest/gtest.h>

#include <limits>

namespace horopter::hardware {
namespace {

TEST(FieldChecker, NamesWhatDoesNotHoldAndNothingElse) {
  FieldChecker part("gain.");
  part.Positive("p", 0);
  FieldChecker check("motor.");
  check.Require(true, "size", 3, "must be odd");
  check.Require(false, "size", 4, "must be odd");
  check.NotNegative("zero", 0);
  check.NotNegative("slip", -0.5);
  check.Positive("speed", std::numeric_limits<double>::quiet_NaN());
  check.Part(part.Take());

  const auto errors = check.Take();
  ASSERT_EQ(errors.size(), 4u);
  EXPECT_EQ(errors[0].ToString(), "motor.size = 4: must be odd");
  EXPECT_EQ(errors[1].ToString(), "motor.slip = -0.5: must be finite and not negative");
  EXPECT_EQ(errors[2].ToString(), "motor.speed = nan: must be finite and positive");
  EXPECT_EQ(errors[3].ToString(), "motor.gain.p = 0: must be finite and positive");
}

}  // namespace
}  // namespace horopter::hardware
