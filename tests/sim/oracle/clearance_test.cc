// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "tests/sim/oracle/oracle_scene.h"

namespace horopter::sim {
namespace {

constexpr double kExact_m = 1e-9;

/// A robot of a box with a ball on an arm, a wall, a box, a floor under all, a rug on it, and a
/// ghost that does not collide.
constexpr const char* kRoom = R"(
    <geom name="ground" type="plane" size="5 5 1"/>
    <body name="floor"><geom name="rug" type="box" size="2 2 0.01"/></body>
    <geom name="floor" type="box" size="5 5 0.001"/>
    <geom name="ghost" type="box" size="0.1 0.1 0.1" pos="0.3 0 0.2" contype="0" conaffinity="0"/>
    <geom name="picky" type="box" size="0.1 0.1 0.1" pos="-0.4 0 0.2" contype="2" conaffinity="4"/>
    <geom name="wall" type="box" size="0.1 3 1" pos="2 0 1"/>
    <geom name="crate" type="box" size="0.2 0.2 0.2" pos="0 -1.5 0.2"/>
    <body name="robot" pos="0 0 0.2"><freejoint/>
      <geom name="hull" type="box" size="0.2 0.15 0.1"/>
      <body name="arm" pos="0 0 0.2"><joint name="arm" axis="0 0 1"/>
        <geom name="ball" type="sphere" size="0.05" pos="0.5 0 0"/>
      </body>
    </body>)";

TEST(Clearance, IsTheNearestPairApartFromTheFloorAndTheRobotItself) {
  OracleScene scene(kRoom);
  const Clearance clearance = scene.oracle().ClearanceOf(scene.Body("robot"));
  EXPECT_NEAR(clearance.distance_m, 1.5 - 0.2 - 0.15, kExact_m);
  EXPECT_EQ(clearance.robot_geom, "hull");
  EXPECT_EQ(clearance.other_geom, "crate");
  EXPECT_NEAR((clearance.p_WRobot - clearance.p_WOther).norm(), clearance.distance_m, kExact_m);
  EXPECT_NEAR(clearance.p_WRobot.y(), -0.15, kExact_m);
  EXPECT_NEAR(clearance.p_WOther.y(), -1.3, kExact_m);
}

TEST(Clearance, IgnoresWhatItIsTold) {
  OracleScene scene(kRoom);
  const Clearance clearance =
      scene.oracle().ClearanceOf(scene.Body("robot"), {.ignored_geoms = {scene.Geom("crate")}});
  EXPECT_EQ(clearance.robot_geom, "ball");
  EXPECT_EQ(clearance.other_geom, "wall");
  EXPECT_NEAR(clearance.distance_m, 2 - 0.1 - 0.55, kExact_m);
}

TEST(Clearance, FollowsTheStateAndIsNegativeInside) {
  OracleScene scene(kRoom);
  mjtNum* qpos = scene.world().mutable_data().qpos;
  qpos[0] = 1.43;  // the ball stands 0.08 m deep in the wall, by its centre 0.03
  scene.Sync();
  const Clearance clearance = scene.oracle().ClearanceOf(scene.Body("robot"));
  EXPECT_EQ(clearance.robot_geom, "ball");
  EXPECT_NEAR(clearance.distance_m, -0.08, 1e-6);
  qpos[7] = M_PI / 2;  // the arm to the left: now the hull is the nearest
  scene.Sync();
  const Clearance turned = scene.oracle().ClearanceOf(scene.Body("robot"));
  EXPECT_EQ(turned.robot_geom, "hull");
  EXPECT_NEAR(turned.distance_m, 1.9 - 1.63, kExact_m);
}

TEST(Clearance, BeyondTheSearchLimitThereIsNothing) {
  OracleScene scene(kRoom);
  const Clearance clearance =
      scene.oracle().ClearanceOf(scene.Body("robot"), {.max_distance_m = 0.5});
  EXPECT_EQ(clearance.distance_m, 0.5);
  EXPECT_EQ(clearance.robot_geom, "");
  EXPECT_EQ(clearance.other_geom, "");
}

TEST(Clearance, OfASubtreeCountsTheRestOfTheRobotAsOthers) {
  OracleScene scene(kRoom);
  const Clearance clearance = scene.oracle().ClearanceOf(scene.Body("arm"));
  EXPECT_EQ(clearance.robot_geom, "ball");
  EXPECT_EQ(clearance.other_geom, "hull");
  EXPECT_NEAR(clearance.distance_m, std::hypot(0.3, 0.1) - 0.05, 1e-6);
  EXPECT_THROW(scene.oracle().ClearanceOf(77), std::out_of_range);
}

TEST(Clearance, OfACylinderIsThatOfARoundRobotStandingThere) {
  OracleScene scene(kRoom);
  const UprightCylinder cylinder{0.2, 0.05, 0.35};
  const ClearanceOptions options{.ignored_body = scene.Body("robot")};
  const Clearance at_crate = scene.oracle().ClearanceOf(cylinder, {0.1, -0.9}, options);
  EXPECT_EQ(at_crate.other_geom, "crate");
  EXPECT_EQ(at_crate.robot_geom, "cylinder");
  EXPECT_NEAR(at_crate.distance_m, 1.5 - 0.2 - 0.9 - 0.2, 1e-6);
  EXPECT_NEAR(scene.oracle().ClearanceOf(cylinder, {1.6, 0}, options).distance_m, 0.1, 1e-6);
  EXPECT_NEAR(scene.oracle().ClearanceOf(cylinder, {1.8, 0}, options).distance_m, -0.1, 1e-5);
  EXPECT_LT(scene.oracle().ClearanceOf(cylinder, {0.1, 0}).distance_m, 0) << "it is the robot's";
}

TEST(Clearance, OfACylinderWithoutVolumeHasNoMeaning) {
  OracleScene scene(kRoom);
  EXPECT_THROW(scene.oracle().ClearanceOf({0, 0, 1}, {0, 0}), std::invalid_argument);
  EXPECT_THROW(scene.oracle().ClearanceOf({0.1, 1, 1}, {0, 0}), std::invalid_argument);
  EXPECT_THROW(scene.oracle().ClearanceOf({0.1, 0, 1}, {0, 0}, {.ignored_body = 99}),
               std::out_of_range);
}

TEST(Clearance, UprightPlaneIsAWallAndALevelOneTheFloor) {
  const auto world = World::FromXml(R"(
<mujoco>
  <worldbody>
    <geom type="plane" size="5 5 1"/>
    <geom name="left_wall" type="plane" size="5 5 1" pos="0 1 0" xyaxes="1 0 0 0 0 1"/>
    <body name="robot"><geom name="hull" type="box" size="0.2 0.3 0.1" pos="0 0 0.1"/></body>
  </worldbody>
</mujoco>)");
  CollisionOracle oracle(world->model());
  oracle.Sync(world->data());
  const Clearance clearance = oracle.ClearanceOf(world->Id(mjOBJ_BODY, "robot"));
  EXPECT_NEAR(clearance.distance_m, 0.7, 1e-9);
  EXPECT_EQ(clearance.other_geom, "left_wall");
}

}  // namespace
}  // namespace horopter::sim
