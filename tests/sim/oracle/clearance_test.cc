// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/sim/oracle/oracle_scene.h"

namespace horopter::sim {
namespace {

using Eigen::Vector3d;
using hardware::Pose;

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

TEST(Clearance, AlongAPathIsThatOfItsWorstPose) {
  OracleScene scene(kRoom);
  std::vector<Pose> path;
  for (int i = 0; i <= 20; ++i) path.push_back(hardware::ToPose({0.1 * i - 1, -0.5, 0.1 * i}, 0.2));
  const PathClearance along = scene.oracle().ClearanceAlong(scene.Body("robot"), path);

  double least = 1e9;
  std::size_t where = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Eigen::Quaterniond q(path[i].linear());
    mjtNum* qpos = scene.world().mutable_data().qpos;
    Eigen::Map<Vector3d>{qpos} = path[i].translation();
    qpos[3] = q.w(), qpos[4] = q.x(), qpos[5] = q.y(), qpos[6] = q.z();
    scene.Sync();
    const double distance = scene.oracle().ClearanceOf(scene.Body("robot")).distance_m;
    if (distance < least) least = distance, where = i;
  }
  EXPECT_NEAR(along.nearest.distance_m, least, kExact_m);
  EXPECT_EQ(along.pose_index, where);
  EXPECT_NE(along.nearest.other_geom, "");
}

TEST(Clearance, OfAnEmptyPathIsTheSearchLimit) {
  OracleScene scene(kRoom);
  const PathClearance along = scene.oracle().ClearanceAlong(scene.Body("robot"), {});
  EXPECT_EQ(along.nearest.distance_m, ClearanceOptions{}.max_distance_m);
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
