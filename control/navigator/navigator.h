// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "control/base/waypoint_controller.h"
#include "control/navigator/obstacle_memory.h"
#include "control/navigator/scene_view.h"
#include "control/navigator/strips.h"
#include "hardware/types/pose.h"
#include "hardware/types/time.h"

namespace horopter::control {

/// What the navigator goes by. Lengths in metres, times in seconds, angles in radians.
///
/// The first block is the paper's rule (Chessa et al. 2014, "Navigation"), which leaves its numbers
/// open; the second is what a robot with a width and a narrow view needs besides. Setting
/// obstacle_test = kCentralImage, stop_distance_m = 0, side_hold_m = 0 and memory.keep_s = 0 gives
/// the paper's rule alone.
struct NavigatorConfig {
  ObstacleTest obstacle_test = ObstacleTest::kCorridor;
  StripConfig strips;
  double obstacle_distance_m = 0.9;    ///< an obstacle nearer than this is avoided
  double avoid_angle_rad = M_PI / 10;  ///< of the intermediate waypoint, off the robot's heading
  double avoid_fraction = 0.5;         ///< its distance, as a part of the remaining distance
  double avoid_min_m = 0.5;            ///< and the bounds of that distance
  double avoid_max_m = 1.0;
  double goal_tolerance_m = 0.08;

  double stop_distance_m = 0.42;   ///< forward motion ends here: rotate to the freer side instead
  double slow_distance_m = 0.8;    ///< from here to stop_distance_m the speed falls to zero
  double max_view_age_s = 1.0;     ///< with an older view, or none, the robot stands still
  double side_switch_ratio = 1.5;  ///< the other side must be this much freer to change sides
  double side_hold_m = 0.6;        ///< the chosen side is kept until so far driven to the goal
  double stuck_after_s = 40;       ///< without getting nearer the goal by stuck_progress_m
  double stuck_progress_m = 0.05;
  ObstacleMemoryConfig memory;

  double gaze_min_m = 0.6;  ///< bounds of the fixation distance
  double gaze_max_m = 1.5;
  double gaze_height_m = 0.10;        ///< height of the gaze target in the base frame
  double gaze_max_bearing_rad = 0.5;  ///< so that what lies straight ahead stays in view

  WaypointControllerConfig controller;

  /// Every bad field, its own parts included.
  std::vector<hardware::FieldError> Validate() const;
};

enum class NavigatorState {
  kIdle,      ///< no goal
  kBlind,     ///< no view yet, or too old a one: standing still
  kDriving,   ///< to the goal
  kAvoiding,  ///< to an intermediate waypoint
  kTurning,   ///< in place, towards the goal or the waypoint
  kReached,
  kStuck,  ///< gave up: no progress; stays until SetGoal()
};

const char* ToString(NavigatorState state);

/// What the robot should do now, and why.
struct NavigatorDecision {
  hardware::Time t{};
  NavigatorState state = NavigatorState::kIdle;
  hardware::Twist2 command;
  std::optional<hardware::Pose2> waypoint;  ///< intermediate, in O; heading from the robot to it
  std::optional<Obstacle> obstacle;         ///< the one being avoided, as last seen
  Eigen::Vector3d gaze_B = Eigen::Vector3d::Zero();  ///< where to look, in the base frame [m]
  double remaining_m = 0;                            ///< to the goal; 0 without one
  std::string reason;                                ///< one line for people and logs
};

/// Drives to a goal round what the cameras see.
///
/// The paper's rule: the image is cut into a left, a central and a right area. When a region in
/// the central one is nearer than a limit, the robot heads for an intermediate waypoint at +-pi/10
/// of its heading, on the side whose nearest thing is further, at a distance proportional to the
/// remaining one. A new obstacle overwrites the waypoint; once it is reached the goal counts again.
///
/// Additions, each with its own setting:
/// - Corridor test (obstacle_test): "central" is the strip of ground that the robot would sweep on
///   its way to the current target, not a part of the image.
/// - Memory: what has left the narrow view still stands there for a while.
/// - Stop distance: never forward into something near ahead; rotate to the freer side instead.
/// - Blind: no motion before the first view or with one that is too old.
/// - Side hold: the side is changed only for a clearly freer one, so that the robot does not
/// dither.
/// - Target in front: what lies beyond the current target is not in its way.
/// - Stuck: without progress for a while the goal counts as unreachable, and the robot stops.
///
/// Frames: O is the odometry frame in which goals are given (the base at the start of the run), B
/// the base. Time comes in through the arguments alone: the same calls give the same decisions.
class Navigator {
 public:
  /// @throws hardware::ConfigError
  explicit Navigator(const NavigatorConfig& config);

  /// Drops the current goal and whatever avoidance was going on; what is remembered stays.
  /// @throws std::invalid_argument when the goal is not finite
  void SetGoal(const Eigen::Vector2d& p_OG);

  /// A view has been processed. May come late: `X_OB` is where odometry had the base when the
  /// images were taken.
  /// @throws std::invalid_argument when the maps differ in size, or the view is older than the last
  void OnView(const SceneView& view, const hardware::Pose2& X_OB_at_capture);

  /// One step of control. @param t does not decrease
  NavigatorDecision Update(hardware::Time t, const hardware::Pose2& X_OB);

 private:
  enum class Side { kLeft, kRight };

  struct Progress {
    double best_remaining_m = 0;
    hardware::Time since{};
  };

  Eigen::Vector2d CurrentTarget() const;
  void ConsiderAvoiding(const StripMeasurements& strips, const hardware::Pose2& X_OB);
  Side ChooseSide(const StripMeasurements& strips, const hardware::Pose2& X_OB) const;
  void ForgetSideAfterProgress(const hardware::Pose2& X_OB);
  bool UpdateProgress(hardware::Time t, double remaining_m);
  double ClearanceAhead(const hardware::Pose2& X_OB) const;
  Eigen::Vector3d GazeTarget(const hardware::Pose2& X_OB) const;

  NavigatorConfig config_;
  WaypointController controller_;
  ObstacleMemory memory_;
  std::optional<Eigen::Vector2d> p_OG_;
  std::optional<hardware::Pose2> waypoint_;
  std::optional<Obstacle> obstacle_;
  std::optional<Side> side_;
  std::optional<hardware::Pose2> goal_leg_start_;  ///< where the current drive to the goal began
  std::optional<hardware::Time> last_view_;
  std::optional<Progress> progress_;
  NavigatorState final_ = NavigatorState::kIdle;  ///< kReached or kStuck once it came to that
};

}  // namespace horopter::control
