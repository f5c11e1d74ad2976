// SPDX-License-Identifier: Apache-2.0
#include "control/base/waypoint_controller.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "control/base/unicycle.h"

namespace horopter::control {
namespace {

using hardware::Pose2;
using hardware::Time;
using std::chrono::milliseconds;

struct Drive {
  double seconds = 0;
  double path_m = 0;
  Pose2 end;
  bool arrived = false;
};

/// An ideal unicycle under the controller, 50 Hz, for at most a minute.
Drive DriveTo(const Eigen::Vector2d& target, Pose2 pose) {
  WaypointController controller({});
  controller.SetTarget(target);
  Drive drive;
  for (int i = 0; i < 3000 && !drive.arrived; ++i) {
    const auto out = controller.Update(Time(milliseconds(20 * i)), pose);
    drive.arrived = out.arrived;
    drive.path_m += 0.02 * std::abs(out.command.forward_m_s);
    pose = AlongArc(pose, 0.02 * out.command.forward_m_s, 0.02 * out.command.turn_rad_s);
    drive.seconds = 0.02 * i;
  }
  drive.end = pose;
  return drive;
}

TEST(WaypointController, ReachesPointsAllRoundWithoutDetour) {
  for (double bearing = -M_PI; bearing < M_PI; bearing += 0.3) {
    for (const double distance : {0.1, 0.5, 2.0}) {
      const Eigen::Vector2d target(distance * std::cos(bearing), distance * std::sin(bearing));
      const Drive drive = DriveTo(target, {});
      ASSERT_TRUE(drive.arrived) << bearing << " " << distance;
      EXPECT_LE(std::hypot(drive.end.x_m - target.x(), drive.end.y_m - target.y()), 0.05);
      EXPECT_LT(drive.path_m, 1.1 * distance + 0.01) << bearing << " " << distance;
    }
  }
}

TEST(WaypointController, TurnsInPlaceWhenThePointIsAbeam) {
  WaypointController controller({});
  controller.SetTarget({0, 1});
  const auto out = controller.Update({}, {});
  EXPECT_TRUE(out.turning_in_place);
  EXPECT_EQ(out.command.forward_m_s, 0);
  EXPECT_GT(out.command.turn_rad_s, 0);  // left
  EXPECT_NEAR(out.heading_error_rad, M_PI / 2, 1e-12);
}

TEST(WaypointController, SlowsWhenTurnedAway) {
  double last = 1;
  for (const double off : {0.0, 0.2, 0.4}) {
    WaypointController controller({});
    controller.SetTarget({2, 0});
    const double forward = controller.Update({}, {0, 0, off}).command.forward_m_s;
    EXPECT_LT(forward, last);
    EXPECT_GT(forward, 0);
    last = forward;
  }
}

TEST(WaypointController, WithoutATargetStandsStill) {
  WaypointController controller({});
  const auto out = controller.Update({}, {1, 2, 3});
  EXPECT_TRUE(out.arrived);
  EXPECT_EQ(out.command.forward_m_s, 0);
  EXPECT_EQ(out.command.turn_rad_s, 0);
}

TEST(WaypointController, ValidateNamesEveryBadField) {
  EXPECT_TRUE(WaypointControllerConfig{}.Validate().empty());
  WaypointControllerConfig bad;
  bad.linear.output_limit = -1;
  bad.turn_in_place_rad = 2;
  bad.arrival_m = 0;
  bad.min_forward_m_s = -1;
  EXPECT_EQ(bad.Validate().size(), 4u);
  EXPECT_THROW(WaypointController{bad}, hardware::ConfigError);
}

}  // namespace
}  // namespace horopter::control
