// SPDX-License-Identifier: Apache-2.0
#include "sim/faults/mount_faults.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace horopter::sim {
namespace {

using hardware::Eye;
using hardware::Pose;
using hardware::Time;

const std::string kRoom = std::string(HOROPTER_SOURCE_DIR) + "/scenes/koala/empty_room.xml";
constexpr double kDegree = M_PI / 180;

Time At(double s) { return Time(hardware::FromSeconds(s)); }

double Baseline(const World& world) {
  return (world.X_WCamera("left").translation() - world.X_WCamera("right").translation()).norm();
}

TEST(MountFaults, WithoutFaultsNothingMoves) {
  World world(kRoom);
  const Pose left = world.X_WCamera("left");
  MountFaults faults(world, {{SwappedPair{}}, {Backlash{}}});
  EXPECT_TRUE(faults.none());
  faults.Update(At(1));
  EXPECT_EQ(world.X_WCamera("left").matrix(), left.matrix());
}

TEST(MountFaults, WrongBaselineMovesBothEyesApartAndBack) {
  World world(kRoom);
  const Pose left = world.X_WCamera("left"), right = world.X_WCamera("right");
  MountFaults faults(world, {{WrongBaseline{0.012}, {At(1), At(2)}}});
  faults.Update(At(0.5));
  EXPECT_EQ(world.X_WCamera("left").matrix(), left.matrix());
  faults.Update(At(1));
  EXPECT_NEAR(Baseline(world), 0.08 + 0.012, 1e-12);
  const Pose wide = world.X_WCamera("left");
  EXPECT_NEAR((wide.translation() - left.translation()).y(), 0.006, 1e-12);
  EXPECT_EQ(wide.linear(), left.linear());
  world.Step();
  EXPECT_NEAR(Baseline(world), 0.092, 1e-9) << "it stays so";
  faults.Update(At(2));
  world.Reset();
  EXPECT_EQ(world.X_WCamera("left").matrix(), left.matrix());
  EXPECT_EQ(world.X_WCamera("right").matrix(), right.matrix());
}

TEST(MountFaults, PitchTurnsDownAndRollTurnsTheRightSideDown) {
  World world(kRoom);
  const Pose sound = world.X_WCamera("left"), other = world.X_WCamera("right");
  MountFaults faults(world, {{MisalignedEye{Eye::kLeft, 2 * kDegree, 0}},
                             {MisalignedEye{Eye::kLeft, 0, 3 * kDegree}, {At(1), At(2)}}});
  faults.Update(At(0));
  const Eigen::Matrix3d pitched = world.X_WCamera("left").linear();
  EXPECT_NEAR(std::asin(-pitched(2, 2)), 2 * kDegree, 1e-9) << "optical axis below the horizon";
  EXPECT_NEAR(pitched(2, 0), 0, 1e-12) << "the image's x axis stays level";
  faults.Update(At(1));
  const Eigen::Matrix3d both = world.X_WCamera("left").linear();
  EXPECT_NEAR((both.col(2) - pitched.col(2)).norm(), 0, 1e-12) << "roll leaves the optical axis";
  EXPECT_NEAR(std::acos(both.col(0).dot(pitched.col(0))), 3 * kDegree, 1e-9);
  EXPECT_LT(both(2, 0), 0) << "x, to the right, points down";
  EXPECT_EQ(world.X_WCamera("left").translation(), sound.translation());
  EXPECT_EQ(world.X_WCamera("right").matrix(), other.matrix());
}

TEST(MountFaults, CamerasOnOnePlateMoveThemselves) {
  const auto world = World::FromXml(R"(<mujoco><worldbody><body name="plate" euler="0 0 90">
      <geom size="0.1"/><joint/>
      <camera name="left" pos="0 0.03 0"/><camera name="right" pos="0 -0.03 0"/>
    </body></worldbody></mujoco>)");
  MountFaults faults(*world, {{WrongBaseline{-0.01}}});
  faults.Update(At(0));
  EXPECT_NEAR(Baseline(*world), 0.05, 1e-12);
}

TEST(MountFaults, EyesThatWouldMeetAndScenesWithoutEyesAreRefused) {
  World world(kRoom);
  try {
    MountFaults faults(world, {{WrongBaseline{-0.08}}});
    FAIL() << "expected ConfigError";
  } catch (const hardware::ConfigError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("0.08 m apart"));
  }
  const auto empty = World::FromXml("<mujoco/>");
  EXPECT_THROW(MountFaults(*empty, {{WrongBaseline{0.01}}}), SceneError);
}

}  // namespace
}  // namespace horopter::sim
