// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <vector>

#include "control/base/waypoint_controller.h"
#include "control/navigator/obstacle_memory.h"
#include "control/navigator/strips.h"
#include "hardware/types/config_error.h"

namespace horopter::control {

/// What the navigator goes by. Lengths in metres, times in seconds, angles in radians.
///
/// The first block is the paper's rule (Chessa et al. 2014, "Navigation"), which leaves its numbers
/// open; the second is what a robot with a width and a narrow view needs besides. Paper() takes the
/// second away again, but for the two stops (blind, stuck).
struct NavigatorConfig {
  ObstacleTest obstacle_test = ObstacleTest::kCorridor;
  StripConfig strips;
  double obstacle_distance_m = 1.2;    ///< an obstacle nearer than this is avoided
  double avoid_angle_rad = M_PI / 10;  ///< of the intermediate waypoint, off the robot's heading
  double avoid_fraction = 0.5;         ///< its distance, as a part of the remaining distance
  double avoid_min_m = 0.5;            ///< and the bounds of that distance
  double avoid_max_m = 1.0;
  double waypoint_tolerance_m = 0.12;  ///< an intermediate waypoint counts as reached
  double goal_tolerance_m = 0.08;

  int avoid_directions = 8;  ///< multiples of avoid_angle_rad tried on each side for one that
                             ///< is free; 1: the paper's alone
  double avoid_other_side_m = 0.3;  ///< by how much shorter the way on the other side must be for
                                    ///< a held side to be left
  double stop_distance_m = 0.42;    ///< no forward motion with something in the corridor ahead
  double slow_distance_m = 0.70;    ///< from here to stop_distance_m the speed falls
  double max_view_age_s = 1.0;      ///< with an older view, or none, the robot stands still
  double side_switch_ratio = 1.5;   ///< a held side is left only for one so many times freer
  double side_hold_m = 0.6;         ///< a side is held until so far driven since the last waypoint
  double stuck_after_s = 40;        ///< without getting nearer the goal by stuck_progress_m
  double stuck_progress_m = 0.05;
  ObstacleMemoryConfig memory{.confirm_beyond_m = 0.6};

  double gaze_min_m = 1.0;  ///< bounds of the fixation distance
  double gaze_max_m = 2.0;
  double gaze_height_m = 0.10;        ///< height of the gaze target in the base frame
  double gaze_max_bearing_rad = 0.3;  ///< so that what lies straight ahead stays in view

  WaypointControllerConfig controller;

  /// The paper's rule alone.
  static NavigatorConfig Paper();

  /// Every bad field, its own parts included.
  std::vector<hardware::FieldError> Validate() const;
};

}  // namespace horopter::control
