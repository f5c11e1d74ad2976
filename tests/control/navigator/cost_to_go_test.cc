// SPDX-License-Identifier: Apache-2.0
#include "control/navigator/cost_to_go.h"

#include <gtest/gtest.h>

namespace horopter::control {
namespace {

using Eigen::Vector2d;

std::vector<Vector2d> Wall(double x, double from_y, double to_y) {
  std::vector<Vector2d> points;
  for (double y = from_y; y <= to_y; y += 0.04) points.emplace_back(x, y);
  return points;
}

TEST(CostToGo, FreeGroundCostsTheDistance) {
  const CostToGo cost({}, {0, 0}, {3, 0});
  EXPECT_NEAR(cost.From({0, 0}), 3, 0.06);
  EXPECT_NEAR(cost.From({3, 0}), 0, 0.06);
  // Eight directions overestimate the rest by at most 8.3 %.
  for (const Vector2d& p : {Vector2d(0, 1), Vector2d(1, -0.7), Vector2d(2, 1.2)}) {
    const double straight = (Vector2d(3, 0) - p).norm();
    EXPECT_GE(cost.From(p), straight - 0.06);
    EXPECT_LE(cost.From(p), 1.083 * straight + 0.06);
  }
}

TEST(CostToGo, WayRoundAWallIsPaidFor) {
  const CostToGo cost(Wall(1.5, -1, 0.5), {0, 0}, {3, 0});
  // Over the upper end, which the robot passes at its clearance.
  const double round = 2 * Vector2d(1.5, 0.5 + 0.28).norm();
  EXPECT_GE(cost.From({0, 0}), round - 0.1);
  EXPECT_LE(cost.From({0, 0}), 1.083 * round + 0.1);
  EXPECT_LT(cost.From({1, 0.8}), cost.From({1, -0.8}));
}

TEST(CostToGo, GapNarrowerThanTheRobotIsNoWay) {
  auto walls = Wall(1.5, -2, -0.2);
  for (const Vector2d& p : Wall(1.5, 0.2, 1.0)) walls.push_back(p);
  EXPECT_GT(CostToGo(walls, {0, 0}, {3, 0}).From({0, 0}), 2 * Vector2d(1.5, 1.2).norm());
}

TEST(CostToGo, GoalInsideAnObstacleStillHasACost) {
  const CostToGo cost({{3, 0}}, {0, 0}, {3, 0});
  EXPECT_TRUE(std::isfinite(cost.From({0, 0})));
  EXPECT_GT(cost.From({0, 0}), 3 + 0.2 * 19);
}

TEST(CostToGo, BeyondTheGridTheStraightWayIsAdded) {
  const CostToGo cost({}, {0, 0}, {1, 0});
  EXPECT_NEAR(cost.From({-11.5, 0}), 12.5, 0.2);
}

TEST(CostToGo, GoalBeyondItsReachCostsTheWayThereAndTheRestStraight) {
  const auto wall = Wall(1.5, -1, 0.5);
  const CostToGo near(wall, {0, 0}, {10, 0});
  const CostToGo far(wall, {0, 0}, {1e6, 0});
  EXPECT_NEAR(far.From({0, 0}) - near.From({0, 0}), 1e6 - 10, 1e-6);
  EXPECT_LT(far.From({1, 0.8}), far.From({1, -0.8}));
}

TEST(CostToGo, PointsBeyondItsReachAreLeftOut) {
  auto points = Wall(1.5, -1, 0.5);
  const CostToGo without(points, {0, 0}, {3, 0});
  points.emplace_back(1e6, -1e6);
  EXPECT_EQ(CostToGo(points, {0, 0}, {3, 0}).From({0, 0}), without.From({0, 0}));
}

}  // namespace
}  // namespace horopter::control
