// SPDX-License-Identifier: Apache-2.0
#include "sim/rooms/free_path.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <memory>

#include "sim/world/world.h"

namespace horopter::sim {
namespace {

using Eigen::Vector2d;

/// A probe of radius 0.2 m and two walls at x = 1 with a door between them, `door_m` wide, in the
/// middle of a floor that ends at them.
struct Doorway {
  explicit Doorway(double door_m)
      : world(World::FromXml(fmt::format(
            R"(<mujoco><worldbody>
                 <body name="probe"><geom type="cylinder" size="0.2 0.1" pos="0 0 0.15"/></body>
                 <geom type="box" size="0.05 1 0.3" pos="1 {0} 0.3"/>
                 <geom type="box" size="0.05 1 0.3" pos="1 -{0} 0.3"/>
               </worldbody></mujoco>)",
            1 + door_m / 2))),
        oracle(world->model()) {
    oracle.Sync(world->data());
  }
  PathSearch Search(double cell_m = 0.05) const {
    const Eigen::AlignedBox2d floor(Vector2d(-0.5, -1), Vector2d(2.5, 1));
    return PathSearch(oracle, world->Id(mjOBJ_BODY, "probe"), floor, cell_m);
  }

  std::unique_ptr<World> world;
  CollisionOracle oracle;
};

const Vector2d kStart(0, 0.4), kGoal(2, -0.37);

TEST(PathSearch, ClearanceIsTheDistanceOfTheProbe) {
  const Doorway doorway(0.6);
  const PathSearch search = doorway.Search();
  EXPECT_NEAR(search.ClearanceAt({1, 0}), 0.1, 1e-6);
  EXPECT_NEAR(search.ClearanceAt({0.5, 0.7}), 1 - 0.05 - 0.5 - 0.2, 1e-6);
  EXPECT_LT(search.ClearanceAt({1, 0.5}), 0);
}

TEST(PathSearch, GoesThroughADoorThatKeepsTheClearance) {
  const Doorway doorway(1.0);
  const auto path = doorway.Search().Find(kStart, kGoal, 0.2);
  ASSERT_TRUE(path.has_value());
  EXPECT_EQ(path->front(), kStart);
  EXPECT_EQ(path->back(), kGoal);
  EXPECT_GE(doorway.Search().ClearanceAlong(*path), 0.2 - 1e-3);
}

TEST(PathSearch, FindsNoneWhereTheDoorIsTooNarrowForTheClearance) {
  const Doorway doorway(1.0);
  EXPECT_FALSE(doorway.Search().Find(kStart, kGoal, 0.31).has_value());
}

TEST(PathSearch, ReportedClearanceIsTheDoorsAndThePathNearlyTheShortest) {
  const Doorway doorway(0.8);
  const auto path = doorway.Search(0.02).Find(kStart, kGoal, 0.15);
  ASSERT_TRUE(path.has_value());
  EXPECT_NEAR(doorway.Search().ClearanceAlong(*path), 0.15, 0.05);
  EXPECT_LT(LengthOf(*path), 1.06 * (kGoal - kStart).norm());
}

TEST(PathSearch, BlockedOnlyWhereTheProbeCannotPass) {
  EXPECT_FALSE(Doorway(0.45).Search(0.02).Blocked(kStart, kGoal));
  EXPECT_TRUE(Doorway(0.35).Search(0.02).Blocked(kStart, kGoal));
}

TEST(PathSearch, AStartThatTouchesHasNoWay) {
  const Doorway doorway(1.0);
  EXPECT_FALSE(doorway.Search().Find({0.9, 0.6}, kGoal, 0.1).has_value());
}

}  // namespace
}  // namespace horopter::sim
