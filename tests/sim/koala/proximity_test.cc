// SPDX-License-Identifier: Apache-2.0
#include "sim/koala/proximity.h"

#include <gtest/gtest.h>

#include <string>

namespace horopter::sim {
namespace {

class ProximityTest : public testing::Test {
 protected:
  /// Puts the front of obstacle_1 (0.12 m before its middle) at a distance from the base's origin.
  void ObstacleAt(double x_m, double y_m) {
    hardware::Pose X = hardware::Pose::Identity();
    X.translation() << x_m, y_m, 0;
    world_.PlaceBody("obstacle_1", X);
  }

  World world_{std::string(HOROPTER_SOURCE_DIR) + "/scenes/koala/room.xml"};
  KoalaProximity proximity_{world_};
};

TEST_F(ProximityTest, SeesNothingInTheFreeRoomNorTheRobotItself) {
  for (const int value : proximity_.Read(world_)) EXPECT_EQ(value, 0);
}

TEST_F(ProximityTest, ValuesFallLinearlyWithDistance) {
  // Sensors 0 and 8 look straight ahead from x = 0.175 m, 0.015 m beside the middle.
  for (const double distance_m : {0.05, 0.1, 0.25, 0.4}) {
    ObstacleAt(0.175 + distance_m + 0.12, 0);
    const auto values = proximity_.Read(world_);
    EXPECT_NEAR(values[0], 1024 * (1 - distance_m / 0.5), 1);
    EXPECT_EQ(values[0], values[8]);
  }
  ObstacleAt(0.175 + 0.51 + 0.12, 0);
  EXPECT_EQ(proximity_.Read(world_)[0], 0);
}

TEST_F(ProximityTest, LeftIsZeroToSevenFromFrontToRear) {
  ObstacleAt(0, 0.45);
  const auto left = proximity_.Read(world_);
  EXPECT_GT(left[4], 0);
  EXPECT_GT(left[5], 0);
  EXPECT_EQ(left[12], 0);
  ObstacleAt(0, -0.45);
  const auto right = proximity_.Read(world_);
  EXPECT_EQ(right[12], left[4]);
  EXPECT_EQ(right[13], left[5]);
  ObstacleAt(-0.45, 0);
  const auto rear = proximity_.Read(world_);
  EXPECT_GT(rear[7], 0);
  EXPECT_EQ(rear[7], rear[15]);
  EXPECT_EQ(rear[0], 0);
}

TEST_F(ProximityTest, SensorsPointAwayFromTheRobot) {
  for (int i = 0; i < kKoalaProximityCount; ++i) {
    const int site = world_.Id(mjOBJ_SITE, "ir_" + std::to_string(i));
    const mjtNum* p = world_.data().site_xpos + 3 * site;
    const mjtNum* axes = world_.data().site_xmat + 9 * site;
    EXPECT_GT(p[0] * axes[2] + p[1] * axes[5], 0) << i;
    EXPECT_NEAR(axes[8], 0, 1e-9) << i;
    EXPECT_EQ(i<8, p[1]> 0) << i;
  }
}

}  // namespace
}  // namespace horopter::sim
