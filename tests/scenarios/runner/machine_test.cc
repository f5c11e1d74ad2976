// SPDX-License-Identifier: Apache-2.0
#include "scenarios/runner/machine.h"

#include <gtest/gtest.h>

namespace horopter::scenarios {
namespace {

TEST(ThisMachine, HasCoresAndALoad) {
  const Machine machine = ThisMachine();
  EXPECT_GT(machine.cores, 0u);
  ASSERT_TRUE(machine.load.has_value());
  EXPECT_GE(*machine.load, 0);
}

TEST(DescribeMachine, SaysWhatIsKnown) {
  EXPECT_EQ(DescribeMachine({"A Processor", 2, 0.5}), "A Processor, 2 cores");
  EXPECT_EQ(DescribeMachine({"", 2, {}}), "unknown processor, 2 cores");
  EXPECT_EQ(DescribeMachine({}), "unknown machine");
}

}  // namespace
}  // namespace horopter::scenarios
