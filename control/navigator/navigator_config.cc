// SPDX-License-Identifier: Apache-2.0
#include "control/navigator/navigator_config.h"

#include <string>
#include <utility>

#include "hardware/types/field_checker.h"

namespace horopter::control {
NavigatorConfig NavigatorConfig::Paper() {
  NavigatorConfig config;
  config.obstacle_test = ObstacleTest::kCentralImage;
  config.strips.central_fraction = 0.6;  // room for the robot beside what the image's middle shows
  config.avoid_min_m = 0.2;              // no bounds but what the controller needs:
  config.avoid_max_m = 100;              // proportional to the remaining distance
  config.avoid_directions = 1;
  config.stop_distance_m = 0;
  config.slow_distance_m = 0;
  config.side_switch_ratio = 1;
  config.side_hold_m = 0;
  config.memory.keep_s = 0;
  return config;
}

std::vector<hardware::FieldError> NavigatorConfig::Validate() const {
  hardware::FieldChecker check("navigator.");
  check.Part(strips.Validate());
  check.Part(memory.Validate());
  check.Part(controller.Validate());

  check.Positive("obstacle_distance_m", obstacle_distance_m);
  check.Require(avoid_angle_rad > 0 && avoid_angle_rad <= M_PI / 2, "avoid_angle_rad",
                avoid_angle_rad, "must be above 0 and at most pi/2");
  check.Positive("avoid_fraction", avoid_fraction);
  check.Require(avoid_min_m > waypoint_tolerance_m, "avoid_min_m", avoid_min_m,
                "must be above waypoint_tolerance_m, or a waypoint is reached where it is set");
  check.Require(avoid_max_m >= avoid_min_m, "avoid_max_m", avoid_max_m,
                "must be at least avoid_min_m");
  check.Require(waypoint_tolerance_m >= controller.arrival_m, "waypoint_tolerance_m",
                waypoint_tolerance_m, "must be at least controller.arrival_m");
  check.Require(goal_tolerance_m >= controller.arrival_m, "goal_tolerance_m", goal_tolerance_m,
                "must be at least controller.arrival_m");

  check.NotNegative("stop_distance_m", stop_distance_m);
  check.Require(slow_distance_m >= stop_distance_m, "slow_distance_m", slow_distance_m,
                "must be at least stop_distance_m");
  check.Positive("max_view_age_s", max_view_age_s);
  check.Require(side_switch_ratio >= 1, "side_switch_ratio", side_switch_ratio,
                "must be at least 1");
  check.NotNegative("side_hold_m", side_hold_m);
  check.Positive("stuck_after_s", stuck_after_s);
  check.Positive("stuck_progress_m", stuck_progress_m);

  check.Require(avoid_directions >= 1 && avoid_directions * avoid_angle_rad <= M_PI,
                "avoid_directions", avoid_directions,
                "must be at least 1, and times avoid_angle_rad at most pi");
  check.NotNegative("avoid_other_side_m", avoid_other_side_m);
  check.Positive("gaze_min_m", gaze_min_m);
  check.Require(gaze_max_m >= gaze_min_m, "gaze_max_m", gaze_max_m, "must be at least gaze_min_m");
  check.Require(std::isfinite(gaze_height_m), "gaze_height_m", gaze_height_m, "must be finite");
  check.Require(gaze_max_bearing_rad >= 0 && gaze_max_bearing_rad < M_PI / 2,
                "gaze_max_bearing_rad", gaze_max_bearing_rad,
                "must be at least 0 and less than pi/2");
  return check.Take();
}

}  // namespace horopter::control
