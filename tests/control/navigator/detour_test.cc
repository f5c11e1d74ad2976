// SPDX-License-Identifier: Apache-2.0
#include "control/navigator/detour.h"

#include <gtest/gtest.h>

#include <cmath>

namespace horopter::control {
namespace {

using Eigen::Vector2d;

constexpr double kStep = M_PI / 10;

/// Points of a wall parallel to y.
std::vector<Vector2d> Wall(double x, double from_y, double to_y) {
  std::vector<Vector2d> points;
  for (double y = from_y; y <= to_y; y += 0.04) points.emplace_back(x, y);
  return points;
}

std::vector<Vector2d> Joined(std::vector<Vector2d> a, const std::vector<Vector2d>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

std::optional<Detour> Choose(const KnownGround& known, double distance_m = 1,
                             std::optional<Strip> held = {}) {
  return ShortestDetour(known, {3, 0}, distance_m, Strip::kLeft, held, {});
}

TEST(ShortestDetour, TakesTheSideOfTheShorterWay) {
  const auto wall = Wall(0.8, -0.3, 0.8);
  const auto detour = Choose({wall, wall});
  ASSERT_TRUE(detour.has_value());
  EXPECT_EQ(detour->side, Strip::kRight);
  EXPECT_LT(detour->turn_rad, 0);
  EXPECT_EQ(detour->distance_m, 1);
}

/// A gap straight beside the first obstacle with another behind it, nearer than a whole waypoint
/// and the robot's front: turning away from the gap would be the long way round.
TEST(ShortestDetour, GoesAsFarAsADirectionIsFree) {
  const auto known = Joined(Wall(0.6, -0.3, 0.08), Wall(1.2, 0.3, 1.4));
  const auto detour = Choose({known, known});
  ASSERT_TRUE(detour.has_value());
  const NavigatorConfig config;
  const double free_m =
      MeasurePoints(known, detour->turn_rad, config.strips).near_m(Strip::kCentre);
  EXPECT_NEAR(detour->turn_rad, 2 * kStep, 1e-12);
  EXPECT_LT(detour->distance_m, 1);
  EXPECT_NEAR(free_m - detour->distance_m,
              config.strips.corridor_half_width_m + config.waypoint_tolerance_m, 1e-12);
}

TEST(ShortestDetour, IsNoneWhereNoDirectionIsFreeFarEnough) {
  std::vector<Vector2d> ring;
  for (double a = 0; a < 2 * M_PI; a += 0.03)
    ring.emplace_back(0.8 * std::cos(a), 0.8 * std::sin(a));
  EXPECT_FALSE(Choose({ring, ring}).has_value());
  for (Vector2d& p : ring) p *= 1.3;  // now there is room for a short waypoint
  ASSERT_TRUE(Choose({ring, ring}).has_value());
  EXPECT_LT(Choose({ring, ring})->distance_m, 1);
}

TEST(ShortestDetour, FirstLegKeepsClearOfWhatOneViewAloneHasSeen) {
  const auto wall = Wall(0.8, -0.3, 0.4);
  const auto certain = Choose({wall, wall});
  ASSERT_TRUE(certain.has_value());
  const Vector2d in_the_way =
      0.4 * Vector2d(std::cos(certain->turn_rad), std::sin(certain->turn_rad));
  const auto wary = Choose({Joined(wall, {in_the_way}), wall});
  ASSERT_TRUE(wary.has_value());
  EXPECT_NE(wary->turn_rad, certain->turn_rad);
}

/// Two rows of mismatches close the shorter way further on, beyond the first waypoint.
TEST(ShortestDetour, WhatOneViewAloneHasSeenClosesNoWayFurtherOn) {
  const auto wall = Wall(0.8, -0.3, 0.8);
  const auto mismatches = Wall(2.2, -2.5, 0.3);
  const auto certain = Choose({wall, wall});
  const auto wary = Choose({Joined(wall, mismatches), wall});
  ASSERT_TRUE(certain.has_value() && wary.has_value());
  EXPECT_EQ(wary->side, certain->side);
  const auto closed = Choose({Joined(wall, mismatches), Joined(wall, mismatches)});
  ASSERT_TRUE(closed.has_value());
  EXPECT_NE(closed->side, certain->side);
}

TEST(ShortestDetour, AHeldSideIsLeftOnlyForAMuchShorterWay) {
  const auto nearly_even = Wall(0.8, -0.5, 0.6);
  EXPECT_EQ(Choose({nearly_even, nearly_even})->side, Strip::kRight);
  EXPECT_EQ(Choose({nearly_even, nearly_even}, 1, Strip::kLeft)->side, Strip::kLeft);
  const auto uneven = Wall(0.8, -0.2, 1.2);
  EXPECT_EQ(Choose({uneven, uneven}, 1, Strip::kLeft)->side, Strip::kRight);
}

}  // namespace
}  // namespace horopter::control
