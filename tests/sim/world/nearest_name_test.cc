// SPDX-License-Identifier: Apache-2.0
#include "sim/world/nearest_name.h"

#include <gtest/gtest.h>

namespace horopter::sim {
namespace {

TEST(NearestName, FindsMisspeltName) {
  EXPECT_EQ(NearestName("left_cmaera", {"right_camera", "left_camera", "floor"}), "left_camera");
  EXPECT_EQ(NearestName("flor", {"wall", "floor"}), "floor");
}

TEST(NearestName, PrefersFirstOfEquals) { EXPECT_EQ(NearestName("box", {"boa", "bob"}), "boa"); }

TEST(NearestName, StaysSilentWhenNothingIsNear) {
  EXPECT_EQ(NearestName("koala", {"window", "table"}), std::nullopt);
  EXPECT_EQ(NearestName("x", {"y"}), std::nullopt);
  EXPECT_EQ(NearestName("koala", {}), std::nullopt);
}

}  // namespace
}  // namespace horopter::sim
