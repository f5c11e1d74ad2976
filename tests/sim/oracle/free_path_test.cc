// SPDX-License-Identifier: Apache-2.0
#include "sim/oracle/free_path.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/sim/oracle/oracle_scene.h"

namespace horopter::sim {
namespace {

using Eigen::Vector2d;

/// A wall across the way with a gap of 0.8 m at y = 0.5, low enough to look over, and a floor.
constexpr const char* kGap = R"(
    <geom name="floor" type="plane" size="5 5 1"/>
    <geom name="lower" type="box" size="0.05 1 0.2" pos="1 -0.9 0.2"/>
    <geom name="upper" type="box" size="0.05 1 0.2" pos="1 1.9 0.2"/>
    <geom name="lamp" type="sphere" size="0.1" pos="0.5 0.5 2"/>
    <body name="robot"><geom name="hull" type="box" size="0.3 0.3 0.3" pos="0 0 0.3"/></body>)";

PathQuery Query(const OracleScene& scene, double radius, double step) {
  PathQuery query;
  query.robot = {radius, 0.05, 0.4};
  query.start_W = {0, 0};
  query.goal_W = {2.01, 0.23};
  query.lower_W = {-0.5, -1.5};
  query.upper_W = {2.5, 2.5};
  query.step_m = step;
  query.clearance.ignored_body = scene.Body("robot");
  return query;
}

TEST(FreePath, BoundsEncloseTheGapsOwnClearance) {
  OracleScene scene(kGap);
  for (const double step : {0.1, 0.05, 0.02}) {
    for (const double radius : {0.1, 0.25, 0.39, 0.45}) {
      const WidestPath path = FindWidestPath(scene.oracle(), Query(scene, radius, step));
      const double truth = 0.4 - radius;  // half the gap, less the robot
      EXPECT_LE(path.clearance_at_least_m, truth + 1e-6) << "radius " << radius;
      EXPECT_GE(path.clearance_at_most_m, truth - 1e-6) << "radius " << radius;
      EXPECT_LT(path.clearance_at_most_m - path.clearance_at_least_m, 1.5 * step);
    }
  }
}

TEST(FreePath, KeepsItsClearanceEverywhereAlongIt) {
  OracleScene scene(kGap);
  const PathQuery query = Query(scene, 0.2, 0.05);
  const WidestPath path = FindWidestPath(scene.oracle(), query);
  ASSERT_GT(path.points_W.size(), 10u);
  EXPECT_EQ(path.points_W.front(), query.start_W);
  EXPECT_EQ(path.points_W.back(), query.goal_W);
  double least = 1e9;
  for (std::size_t i = 1; i < path.points_W.size(); ++i) {
    for (double s = 0; s <= 1; s += 0.1) {
      const Vector2d p = path.points_W[i - 1] + s * (path.points_W[i] - path.points_W[i - 1]);
      least =
          std::min(least, scene.oracle().ClearanceOf(query.robot, p, query.clearance).distance_m);
    }
  }
  EXPECT_GE(least, path.clearance_at_least_m - 1e-9);
  EXPECT_LE(least, path.clearance_at_most_m + 1e-9);
}

TEST(FreePath, ThereIsNoneThroughAClosedWall) {
  OracleScene scene(R"(<geom name="wall" type="box" size="0.2 3 0.2" pos="1 0 0.2"/>
                       <body name="robot"/>)");
  const WidestPath path = FindWidestPath(scene.oracle(), Query(scene, 0.1, 0.05));
  EXPECT_LT(path.clearance_at_most_m, -0.1);
  // From the middle of the wall the shortest way out is 0.2 m and the cylinder's radius.
  EXPECT_NEAR(path.clearance_at_least_m, -0.3, 0.05);
}

TEST(FreePath, OfABlockedStartIsTheStartsOwnPenetration) {
  OracleScene scene(R"(<geom name="crate" type="box" size="0.2 0.2 0.2" pos="0.25 0 0.2"/>
                       <body name="robot"/>)");
  const WidestPath path = FindWidestPath(scene.oracle(), Query(scene, 0.1, 0.05));
  EXPECT_NEAR(path.clearance_at_most_m, -0.05, 1e-6);
}

TEST(FreePath, PassesUnderWhatHangsHigherThanTheRobot) {
  OracleScene scene(R"(<geom name="beam" type="box" size="0.2 3 0.2" pos="1 0 1.2"/>
                       <body name="robot"/>)");
  PathQuery query = Query(scene, 0.1, 0.1);
  EXPECT_GT(FindWidestPath(scene.oracle(), query).clearance_at_least_m, 0.5);
  query.robot.top_m = 1.1;
  EXPECT_LT(FindWidestPath(scene.oracle(), query).clearance_at_most_m, 0);
}

TEST(FreePath, NamesEveryBadField) {
  OracleScene scene(kGap);
  PathQuery query;
  query.step_m = 0;
  query.robot = {0, 1, 1};
  query.goal_W = {1, 1};
  try {
    FindWidestPath(scene.oracle(), query);
    FAIL() << "it should not hold";
  } catch (const hardware::ConfigError& e) {
    EXPECT_EQ(e.errors().size(), 5u) << e.what();
  }
}

}  // namespace
}  // namespace horopter::sim
