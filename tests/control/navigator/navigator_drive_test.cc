// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <deque>
#include <random>
#include <string>
#include <utility>

#include "control/base/unicycle.h"
#include "control/navigator/navigator.h"
#include "tests/control/navigator/toy_world.h"

namespace horopter::control {
namespace {

using hardware::Pose2;
using hardware::Time;
using std::chrono::milliseconds;

constexpr double kRobotRadius = 0.2;

struct Drive {
  NavigatorState end = NavigatorState::kIdle;
  double seconds = 0;
  double least_clearance_m = std::numeric_limits<double>::infinity();
  Pose2 pose;
  int waypoints = 0;
  std::string log;  ///< every decision
};

/// When views are taken and how late they arrive, in steps of control (25 Hz).
struct Vision {
  int period_steps = 5;
  int latency_steps = 5;
};

/// An ideal unicycle; the camera looks where the navigator wants it to.
Drive DriveThrough(const ToyWorld& world, const Eigen::Vector2d& goal, Pose2 pose,
                   const NavigatorConfig& config, double limit_s = 150, Vision vision = {}) {
  Navigator navigator(config);
  navigator.SetGoal(goal);
  Drive drive;
  double pan = 0;
  std::deque<std::pair<SceneView, Pose2>> pending;
  std::optional<Pose2> last_waypoint;
  for (int step = 0; step * 0.04 < limit_s; ++step) {
    const Time now(milliseconds(40 * step));
    if (step % vision.period_steps == 0) pending.emplace_back(world.View(now, pose, pan), pose);
    if (!pending.empty() &&
        pending.front().first.t_capture + milliseconds(40) * vision.latency_steps <= now) {
      navigator.OnView(pending.front().first, pending.front().second);
      pending.pop_front();
    }
    const NavigatorDecision d = navigator.Update(now, pose);
    drive.log += std::to_string(d.command.forward_m_s) + " " +
                 std::to_string(d.command.turn_rad_s) + " " + ToString(d.state) + " " + d.reason +
                 "\n";
    if (d.waypoint && (!last_waypoint || last_waypoint->x_m != d.waypoint->x_m)) ++drive.waypoints;
    last_waypoint = d.waypoint;
    pan = std::atan2(d.gaze_B.y(), d.gaze_B.x());
    pose = AlongArc(pose, 0.04 * d.command.forward_m_s, 0.04 * d.command.turn_rad_s);
    drive.least_clearance_m =
        std::min(drive.least_clearance_m, world.Clearance(pose, kRobotRadius));
    drive.end = d.state;
    drive.seconds = 0.04 * step;
    drive.pose = pose;
    if (d.state == NavigatorState::kReached || d.state == NavigatorState::kStuck) break;
  }
  return drive;
}

/// A frontal obstacle between start and goal, and two more where a robot might swerve to.
ToyWorld SeededLayout(int seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> shift(-0.15, 0.15), radius(0.10, 0.20);
  std::vector<Pillar> pillars{{{1.3, 0}, 0}, {{2.0, 0.9}, 0}, {{1.7, -1.0}, 0}};
  for (Pillar& p : pillars) {
    p.p_O += Eigen::Vector2d(shift(generator), shift(generator));
    p.radius_m = radius(generator);
  }
  return ToyWorld(pillars);
}

/// A closed ring of pillars round the start, with no gap for the robot.
ToyWorld Ring(double radius_m) {
  std::vector<Pillar> pillars;
  for (int i = 0; i < 36; ++i) {
    const double a = i * M_PI / 18;
    pillars.push_back({{radius_m * std::cos(a), radius_m * std::sin(a)}, 0.1});
  }
  return ToyWorld(pillars);
}

class SeededDrive : public testing::TestWithParam<int> {};

TEST_P(SeededDrive, ReachesTheGoalRoundAFrontalObstacleWithoutContact) {
  const ToyWorld world = SeededLayout(GetParam());
  const Pose2 start{0, 0, 0.087 * std::sin(GetParam())};
  const Drive drive = DriveThrough(world, {2.8, 0}, start, {});
  EXPECT_EQ(drive.end, NavigatorState::kReached)
      << drive.seconds << " s at " << drive.pose.x_m << ", " << drive.pose.y_m << "\n"
      << drive.log.substr(drive.log.size() - 300);
  EXPECT_GE(drive.least_clearance_m, 0.05);
  EXPECT_GE(drive.waypoints, 1);
  EXPECT_LE(std::hypot(drive.pose.x_m - 2.8, drive.pose.y_m), 0.1);
}

INSTANTIATE_TEST_SUITE_P(Layouts, SeededDrive, testing::Range(1, 21));

TEST(NavigatorDrive, SlowVisionIsSafe) {
  NavigatorConfig config;
  config.max_view_age_s = 2.5;
  for (int seed = 1; seed <= 5; ++seed) {
    const Drive drive = DriveThrough(SeededLayout(seed), {2.8, 0}, {}, config, 150, {25, 25});
    EXPECT_EQ(drive.end, NavigatorState::kReached) << seed;
    EXPECT_GE(drive.least_clearance_m, 0.03) << seed;
  }
}

TEST(NavigatorDrive, NoisyViewsWithMismatchesAreSafe) {
  for (int seed = 1; seed <= 5; ++seed) {
    ToyWorld world = SeededLayout(seed);
    world.AddNoise({0.03, 0.4, 0.02, seed});
    const Drive drive = DriveThrough(world, {2.8, 0}, {}, {});
    EXPECT_EQ(drive.end, NavigatorState::kReached) << seed;
    EXPECT_GE(drive.least_clearance_m, 0.03) << seed;
  }
}

TEST(NavigatorDrive, WithoutObstaclesGoesStraight) {
  const Drive drive = DriveThrough(ToyWorld({}), {2, 1}, {}, {});
  EXPECT_EQ(drive.end, NavigatorState::kReached);
  EXPECT_EQ(drive.waypoints, 0);
  EXPECT_LT(drive.seconds, 30);
}

TEST(NavigatorDrive, GoalBehindTheRobotIsReached) {
  EXPECT_EQ(DriveThrough(SeededLayout(1), {-1.5, 0.2}, {}, {}).end, NavigatorState::kReached);
}

TEST(NavigatorDrive, ObstacleBeyondTheGoalIsNoObstacle) {
  const ToyWorld world({{{1.75, 0}, 0.15}});
  const Drive drive = DriveThrough(world, {1.2, 0}, {}, {});
  EXPECT_EQ(drive.end, NavigatorState::kReached);
  EXPECT_EQ(drive.waypoints, 0);
}

TEST(NavigatorDrive, WalledInGivesUpWithoutContact) {
  const Drive drive = DriveThrough(Ring(1.0), {3, 0}, {}, {});
  EXPECT_EQ(drive.end, NavigatorState::kStuck);
  EXPECT_GT(drive.least_clearance_m, 0);
}

TEST(NavigatorDrive, GoalInsideAnObstacleGivesUpWithoutContact) {
  const Drive drive = DriveThrough(ToyWorld({{{1.5, 0}, 0.2}}), {1.5, 0}, {}, {}, 300);
  EXPECT_EQ(drive.end, NavigatorState::kStuck);
  EXPECT_GT(drive.least_clearance_m, 0);
}

TEST(NavigatorDrive, SameInputsGiveTheSameDecisions) {
  const Drive a = DriveThrough(SeededLayout(3), {2.8, 0}, {}, {});
  const Drive b = DriveThrough(SeededLayout(3), {2.8, 0}, {}, {});
  EXPECT_EQ(a.log, b.log);
  EXPECT_NE(a.log, DriveThrough(SeededLayout(4), {2.8, 0}, {}, {}).log);
}

/// The paper's rule with none of the additions but the stops, on what its first experiment shows:
/// one frontal obstacle with room beside it.
TEST(NavigatorDrive, ThePapersRuleAloneGetsRoundAFrontalObstacle) {
  NavigatorConfig paper = NavigatorConfig::Paper();
  paper.obstacle_distance_m = 1.2;  // what scenarios give it
  const Drive drive = DriveThrough(ToyWorld({{{1.5, 0.05}, 0.15}}), {3, 0}, {}, paper);
  EXPECT_EQ(drive.end, NavigatorState::kReached);
  EXPECT_GE(drive.waypoints, 1);
  EXPECT_GT(drive.least_clearance_m, 0);
}

}  // namespace
}  // namespace horopter::control
