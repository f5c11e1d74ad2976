// SPDX-License-Identifier: Apache-2.0
#include "control/navigator/navigator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "tests/control/navigator/toy_world.h"

namespace horopter::control {
namespace {

using hardware::Pose2;
using hardware::Time;
using std::chrono::milliseconds;

Time At(int ms) { return Time(milliseconds(ms)); }

/// One direction on each side, as in the paper.
NavigatorConfig PaperDirections() {
  NavigatorConfig config;
  config.avoid_directions = 1;
  return config;
}

TEST(Navigator, StandsStillWithoutAGoalAndWithoutAView) {
  Navigator navigator({});
  EXPECT_EQ(navigator.Update(At(0), {}).state, NavigatorState::kIdle);
  navigator.SetGoal({2, 0});
  const NavigatorDecision blind = navigator.Update(At(20), {});
  EXPECT_EQ(blind.state, NavigatorState::kBlind);
  EXPECT_EQ(blind.command.forward_m_s, 0);
  EXPECT_EQ(blind.command.turn_rad_s, 0);
}

TEST(Navigator, StopsWhenTheViewIsTooOldAndGoesOnWithTheNext) {
  Navigator navigator({});
  navigator.SetGoal({2, 0});
  const ToyWorld empty({});
  navigator.OnView(empty.View(At(0), {}, 0), {});
  EXPECT_GT(navigator.Update(At(1000), {}).command.forward_m_s, 0);
  const NavigatorDecision stale = navigator.Update(At(1001), {});
  EXPECT_EQ(stale.state, NavigatorState::kBlind);
  EXPECT_EQ(stale.command.forward_m_s, 0);
  navigator.OnView(empty.View(At(1000), {}, 0), {});
  EXPECT_EQ(navigator.Update(At(1020), {}).state, NavigatorState::kDriving);
}

/// The paper's rule: +-pi/10 of the heading, half the remaining distance, the freer side.
TEST(Navigator, WaypointIsAtATenthOfPiOnTheFreerSide) {
  for (const double side : {1.0, -1.0}) {
    Navigator navigator(PaperDirections());
    navigator.SetGoal({1.6, 0});
    const Pose2 pose{0, 0, 0.05};
    // A frontal obstacle, and another on the side that must not be chosen.
    const ToyWorld world({{{0.9, 0}, 0.12}, {{1.0, -0.5 * side}, 0.1}});
    navigator.OnView(world.View(At(0), pose, 0), pose);
    const NavigatorDecision d = navigator.Update(At(20), pose);
    EXPECT_EQ(d.state, NavigatorState::kAvoiding);
    ASSERT_TRUE(d.waypoint.has_value());
    const double heading = 0.05 + side * M_PI / 10;
    EXPECT_NEAR(d.waypoint->heading_rad, heading, 1e-12);
    EXPECT_NEAR(d.waypoint->x_m, 0.8 * std::cos(heading), 1e-12);
    EXPECT_NEAR(d.waypoint->y_m, 0.8 * std::sin(heading), 1e-12);
    ASSERT_TRUE(d.obstacle.has_value());
    EXPECT_NEAR(d.obstacle->near_m, 0.78, 0.03);
    EXPECT_GT(side * d.command.turn_rad_s, 0);
    EXPECT_NE(d.reason.find(side > 0 ? "going left" : "going right"), std::string::npos)
        << d.reason;
  }
}

TEST(Navigator, ANewObstacleOverwritesTheWaypoint) {
  Navigator navigator(PaperDirections());
  navigator.SetGoal({3, 0});
  navigator.OnView(ToyWorld({{{0.9, -0.05}, 0.12}}).View(At(0), {}, 0), {});
  const auto first = navigator.Update(At(20), {}).waypoint;
  ASSERT_TRUE(first.has_value());
  const Pose2 turned{0, 0, first->heading_rad};
  const ToyWorld blocked(
      {{{0.8 * std::cos(turned.heading_rad), 0.8 * std::sin(turned.heading_rad)}, 0.15}});
  navigator.OnView(blocked.View(At(400), turned, 0), turned);
  const auto second = navigator.Update(At(420), turned).waypoint;
  ASSERT_TRUE(second.has_value());
  EXPECT_NEAR(second->heading_rad, 2 * first->heading_rad, 1e-12);
}

TEST(Navigator, TakesTheFreeDirectionNearestToTheGoal) {
  Navigator navigator({});
  navigator.SetGoal({3, 0});
  // A wall ahead that ends 0.5 m to the left, and 1 m to the right.
  std::vector<Pillar> wall;
  for (double y = -1.0; y <= 0.5; y += 0.1) wall.push_back({{0.8, y}, 0.08});
  navigator.OnView(ToyWorld(wall).View(At(0), {}, 0), {});
  const auto waypoint = navigator.Update(At(20), {}).waypoint;
  ASSERT_TRUE(waypoint.has_value());
  EXPECT_NEAR(std::remainder(waypoint->heading_rad, M_PI / 10), 0, 1e-12);
  EXPECT_GT(waypoint->heading_rad, M_PI / 10 + 1e-9);
  // The robot's corridor to the waypoint misses every pillar.
  const Eigen::Vector2d along(std::cos(waypoint->heading_rad), std::sin(waypoint->heading_rad));
  for (const Pillar& pillar : wall) {
    const double ahead = pillar.p_O.dot(along);
    const double beside = std::abs(pillar.p_O.x() * along.y() - pillar.p_O.y() * along.x());
    const double reach = std::hypot(waypoint->x_m, waypoint->y_m);
    EXPECT_TRUE(ahead > reach || beside - pillar.radius_m > 0.2) << pillar.p_O.transpose();
  }
}

TEST(Navigator, ReturnsToTheGoalOnceTheWaypointIsReached) {
  Navigator navigator({});
  navigator.SetGoal({3, 0});
  navigator.OnView(ToyWorld({{{0.9, -0.05}, 0.12}}).View(At(0), {}, 0), {});
  const auto waypoint = navigator.Update(At(20), {}).waypoint;
  ASSERT_TRUE(waypoint.has_value());
  const NavigatorDecision there = navigator.Update(At(40), *waypoint);
  EXPECT_FALSE(there.waypoint.has_value());
  EXPECT_TRUE(there.state == NavigatorState::kDriving || there.state == NavigatorState::kTurning);
}

TEST(Navigator, NeverForwardWithinTheStopDistance) {
  Navigator navigator({});
  navigator.SetGoal({3, 0});
  const ToyWorld world({{{0.5, 0}, 0.12}});
  navigator.OnView(world.View(At(0), {}, 0), {});
  const NavigatorDecision d = navigator.Update(At(20), {});
  EXPECT_EQ(d.command.forward_m_s, 0);
  EXPECT_EQ(d.state, NavigatorState::kTurning);
  EXPECT_NE(d.command.turn_rad_s, 0);
}

TEST(Navigator, DoesNotSwingBetweenSidesThatAreAboutAsFree) {
  Navigator navigator({});
  navigator.SetGoal({3, 0});
  const Pillar front{{0.85, 0}, 0.12};
  const auto side_of = [&](int ms, double left_y, double right_y) {
    const ToyWorld world({front, {{0.9, left_y}, 0.1}, {{0.9, -right_y}, 0.1}});
    navigator.OnView(world.View(At(ms), {}, 0), {});
    return navigator.Update(At(ms + 20), {}).waypoint->y_m > 0;
  };
  const bool left = side_of(0, 0.50, 0.45);
  EXPECT_TRUE(left);
  for (int i = 1; i < 6; ++i) {
    EXPECT_TRUE(side_of(100 * i, i % 2 ? 0.45 : 0.50, i % 2 ? 0.50 : 0.45)) << i;
  }
}

TEST(Navigator, GazeIsAheadOnThePathWithinItsBounds) {
  NavigatorConfig config;
  Navigator navigator(config);
  const auto gaze_to = [&](double x, double y) {
    navigator.SetGoal({x, y});
    return navigator.Update(At(0), {}).gaze_B;
  };
  EXPECT_LT((gaze_to(1, 0.1) - Eigen::Vector3d(1, 0.1, config.gaze_height_m)).norm(), 1e-12);
  EXPECT_NEAR(gaze_to(9, 0).x(), config.gaze_max_m, 1e-12);
  EXPECT_NEAR(gaze_to(0.2, 0).x(), config.gaze_min_m, 1e-12);
  const Eigen::Vector3d abeam = gaze_to(0, 1);
  EXPECT_NEAR(std::atan2(abeam.y(), abeam.x()), config.gaze_max_bearing_rad, 1e-12);
}

TEST(Navigator, AfterTheGoalItTakesAnother) {
  Navigator navigator({});
  navigator.SetGoal({1, 0});
  navigator.OnView(ToyWorld({}).View(At(0), {}, 0), {});
  EXPECT_EQ(navigator.Update(At(20), {0.95, 0, 0}).state, NavigatorState::kReached);
  EXPECT_EQ(navigator.Update(At(40), {0.5, 0, 0}).state, NavigatorState::kReached);  // it stays so
  navigator.SetGoal({2, 0});
  EXPECT_EQ(navigator.Update(At(60), {0.95, 0, 0}).state, NavigatorState::kDriving);
}

TEST(Navigator, RefusesBadInput) {
  NavigatorConfig bad;
  bad.obstacle_distance_m = 0;
  bad.avoid_min_m = 0.1;
  bad.slow_distance_m = 0.1;
  bad.memory.cell_m = 0;
  bad.strips.min_pixels = 0;
  bad.controller.linear.output_limit = 0;
  EXPECT_GE(bad.Validate().size(), 6u);
  EXPECT_THROW(Navigator{bad}, hardware::ConfigError);
  EXPECT_TRUE(NavigatorConfig{}.Validate().empty());

  Navigator navigator({});
  EXPECT_THROW(navigator.SetGoal({std::numeric_limits<double>::quiet_NaN(), 0}),
               std::invalid_argument);
  const ToyWorld empty({});
  navigator.OnView(empty.View(At(100), {}, 0), {});
  EXPECT_THROW(navigator.OnView(empty.View(At(50), {}, 0), {}), std::invalid_argument);
  SceneView uneven = empty.View(At(200), {}, 0);
  uneven.regions.labels = cv::Mat1i(3, 3, 0);
  EXPECT_THROW(navigator.OnView(uneven, {}), std::invalid_argument);
}

}  // namespace
}  // namespace horopter::control
