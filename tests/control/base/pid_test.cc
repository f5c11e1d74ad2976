// SPDX-License-Identifier: Apache-2.0
#include "control/base/pid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace horopter::control {
namespace {

TEST(Pid, TermsAreThoseOfTheTextbook) {
  Pid pid({2, 0.5, 0.1, 100});
  EXPECT_DOUBLE_EQ(pid.Update(1, 0), 2);
  // 2*3 + 0.5*3*0.2 + 0.1*(3-1)/0.2
  EXPECT_DOUBLE_EQ(pid.Update(3, 0.2), 6 + 0.3 + 1);
}

TEST(Pid, OutputStaysWithinItsLimit) {
  Pid pid({10, 1, 1, 0.5});
  for (const double error : {1.0, -3.0, 0.2, 100.0}) {
    EXPECT_LE(std::abs(pid.Update(error, 0.1)), 0.5);
  }
}

TEST(Pid, IntegralDoesNotWindUpWhileSaturated) {
  Pid pid({1, 1, 0, 1});
  for (int i = 0; i < 1000; ++i) pid.Update(5, 0.1);
  EXPECT_EQ(pid.integral(), 0);
  EXPECT_LT(pid.Update(-0.1, 0.1), 0);  // follows the error's sign at once
}

TEST(Pid, IntegralRemovesAConstantLoad) {
  // x' = u - 0.3: without the integral the error would stay at 0.3 / proportional.
  Pid pid({1, 0.8, 0, 2});
  double x = 0;
  for (int i = 0; i < 3000; ++i) x += 0.01 * (pid.Update(1 - x, 0.01) - 0.3);
  EXPECT_NEAR(x, 1, 1e-3);
}

TEST(Pid, NoDerivativeKickAfterReset) {
  Pid pid({0, 0, 1, 100});
  pid.Update(0, 0.1);
  pid.Reset();
  EXPECT_EQ(pid.Update(50, 0.1), 0);
}

TEST(Pid, RefusesBadInput) {
  Pid pid({1, 0, 0, 1});
  EXPECT_THROW(pid.Update(std::numeric_limits<double>::quiet_NaN(), 0.1), std::invalid_argument);
  EXPECT_THROW(pid.Update(1, -0.1), std::invalid_argument);
  EXPECT_THROW(Pid({-1, 0, 0, 1}), hardware::ConfigError);
  EXPECT_EQ((PidConfig{-1, -1, -1, 0}.Validate("x").size()), 4u);
  EXPECT_EQ((PidConfig{1, 0, 0, 0}.Validate("linear")[0].field), "linear.output_limit");
}

}  // namespace
}  // namespace horopter::control
