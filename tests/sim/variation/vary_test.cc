// SPDX-License-Identifier: Apache-2.0
#include "sim/variation/vary.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include "hardware/types/config_error.h"
#include "sim/variation/footprint.h"

namespace horopter::sim {
namespace {

/// Three obstacles, a robot, a wall and a small texture: quick to vary many times.
constexpr const char* kScene = R"(<mujoco>
  <compiler angle="degree" autolimits="true"/>
  <asset>
    <texture name="paint" type="2d" builtin="flat" width="16" height="16"/>
    <material name="paint" texture="paint"/>
  </asset>
  <custom><text name="texture:paint" data="plaster,size_m=0.4x0.4"/></custom>
  <worldbody>
    <geom name="floor" type="plane" size="5 5 1"/>
    <geom name="wall" type="plane" size="5 5 1" pos="1.80 0 1" xyaxes="0 -1 0 0 0 1"/>
    <geom name="chest" type="box" size="0.2 0.2 0.2" pos="0.9 0.46 0.2"/>
    <body name="obstacle_1" pos="0.9 0 0"><geom type="box" size="0.1 0.15 0.2" pos="0 0 0.2"/></body>
    <body name="obstacle_2" pos="0.9 -0.5 0"><geom type="cylinder" size="0.1 0.2" pos="0 0 0.2"/></body>
    <body name="obstacle_3" pos="1.62 -0.2 0"><geom type="box" size="0.1 0.1 0.2" pos="0 0 0.2"/></body>
    <body name="base"><freejoint/><geom name="hull" type="box" size="0.15 0.15 0.1" pos="0 0 0.1"/></body>
  </worldbody>
</mujoco>)";

std::string StateOf(const World& world) {
  const mjModel& m = world.model();
  std::string bytes(reinterpret_cast<const char*>(m.body_pos), 3 * m.nbody * sizeof(mjtNum));
  bytes.append(reinterpret_cast<const char*>(world.data().qpos), m.nq * sizeof(mjtNum));
  return bytes.append(reinterpret_cast<const char*>(m.tex_rgb), m.ntexdata);
}

double Heading(const World& world) {
  const Eigen::Matrix3d R = world.X_WBody("base").linear();
  return std::atan2(R(1, 0), R(0, 0));
}

TEST(Vary, SameSeedGivesTheSameWorld) {
  const auto a = World::FromXml(kScene);
  const auto b = World::FromXml(kScene);
  Vary(*a, {}, 7);
  Vary(*b, {}, 7);
  EXPECT_EQ(StateOf(*a), StateOf(*b));
}

TEST(Vary, AnotherSeedMovesTurnsAndRepaints) {
  const auto a = World::FromXml(kScene);
  const auto b = World::FromXml(kScene);
  const Variation va = Vary(*a, {}, 1);
  const Variation vb = Vary(*b, {}, 2);
  ASSERT_EQ(va.obstacles.size(), 3U);
  for (int i = 0; i < 3; ++i) {
    EXPECT_GT((va.obstacles[i].shift_m - vb.obstacles[i].shift_m).norm(), 1e-4);
  }
  EXPECT_NE(va.heading_rad, vb.heading_rad);
  EXPECT_NE(std::memcmp(a->model().tex_rgb, b->model().tex_rgb, a->model().ntexdata), 0);
}

TEST(Vary, ShiftsAndHeadingStayWithinTheirLimitsAndReachTowardsThem) {
  double farthest = 0;
  double most_turned = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const auto world = World::FromXml(kScene);
    const auto before = world->X_WBody("obstacle_2").translation().eval();
    const Variation variation = Vary(*world, {}, seed);
    for (const auto& obstacle : variation.obstacles) EXPECT_LE(obstacle.shift_m.norm(), 0.15);
    const Eigen::Vector3d moved = world->X_WBody("obstacle_2").translation() - before;
    EXPECT_NEAR((moved.head<2>() - variation.obstacles[1].shift_m).norm(), 0, 1e-12);
    EXPECT_EQ(moved.z(), 0);
    EXPECT_NEAR(Heading(*world), variation.heading_rad, 1e-12);
    EXPECT_LE(std::abs(variation.heading_rad), 5 * M_PI / 180);
    farthest = std::max(farthest, moved.norm());
    most_turned = std::max(most_turned, std::abs(variation.heading_rad));
  }
  EXPECT_GT(farthest, 0.12);
  EXPECT_GT(most_turned, 4 * M_PI / 180);
}

TEST(Vary, SwitchingOneThingOffChangesNoOther) {
  const auto full = World::FromXml(kScene);
  const auto still = World::FromXml(kScene);
  const auto straight = World::FromXml(kScene);
  const Variation all = Vary(*full, {}, 5);
  const Variation no_shift = Vary(*still, {.obstacle_shift_m = 0}, 5);
  const Variation no_turn = Vary(*straight, {.heading_rad = 0, .textures = false}, 5);
  EXPECT_EQ(no_shift.heading_rad, all.heading_rad);
  EXPECT_TRUE(no_shift.obstacles.empty());
  EXPECT_EQ(no_turn.heading_rad, 0);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(no_turn.obstacles[i].shift_m, all.obstacles[i].shift_m);
  }
  const auto bytes = full->model().ntexdata;
  EXPECT_EQ(std::memcmp(full->model().tex_rgb, still->model().tex_rgb, bytes), 0);
  EXPECT_NE(std::memcmp(full->model().tex_rgb, straight->model().tex_rgb, bytes), 0);
}

TEST(Vary, NeverPutsAnObstacleIntoSomethingElse) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const auto world = World::FromXml(kScene);
    Vary(*world, {}, seed);
    const Footprint chest = FootprintOf(*world, world->Id(mjOBJ_GEOM, "chest"));
    const Footprint robot = FootprintOfTree(*world, world->Id(mjOBJ_BODY, "base"));
    std::vector<Footprint> obstacles;
    for (const char* name : {"obstacle_1", "obstacle_2", "obstacle_3"}) {
      obstacles.push_back(FootprintOfTree(*world, world->Id(mjOBJ_BODY, name)));
    }
    for (std::size_t i = 0; i < obstacles.size(); ++i) {
      EXPECT_FALSE(obstacles[i].intersects(chest)) << seed;
      EXPECT_GT(obstacles[i].exteriorDistance(robot), 0.1) << seed;
      EXPECT_LT(obstacles[i].max().x(), 1.80) << seed;
      for (std::size_t k = 0; k < i; ++k) {
        EXPECT_FALSE(obstacles[i].intersects(obstacles[k])) << seed;
      }
    }
  }
}

TEST(Vary, ShippedRoomHasThreeObstaclesThatTouchNothing) {
  World world(std::string(HOROPTER_SOURCE_DIR) + "/scenes/koala/room.xml");
  const VariationConfig only_obstacles{.heading_rad = 0, .textures = false};
  const Variation variation = Vary(world, only_obstacles, 3);
  EXPECT_EQ(variation.obstacles.size(), 3U);
  world.Step();
  for (const Contact& contact : world.Contacts()) {
    EXPECT_FALSE(contact.body1.starts_with("obstacle") || contact.body2.starts_with("obstacle"));
  }
}

TEST(Vary, NamesEveryBadField) {
  const auto world = World::FromXml(kScene);
  try {
    Vary(*world, {.obstacle_shift_m = -1, .heading_rad = std::numeric_limits<double>::quiet_NaN()},
         1);
    FAIL() << "expected ConfigError";
  } catch (const hardware::ConfigError& error) {
    EXPECT_EQ(error.errors().size(), 2U);
  }
}

}  // namespace
}  // namespace horopter::sim
