// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "control/base/waypoint_controller.h"
#include "control/navigator/detour.h"
#include "control/navigator/navigator_config.h"
#include "control/navigator/obstacle_memory.h"
#include "control/navigator/scene_view.h"
#include "control/navigator/strips.h"
#include "hardware/types/pose.h"
#include "hardware/types/time.h"

namespace horopter::control {

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
  std::optional<hardware::Pose2> waypoint;  ///< intermediate, in O; its heading is the direction
                                            ///< from where the robot was when it was set
  std::optional<Obstacle> obstacle;         ///< the one being avoided, as last seen
  Eigen::Vector3d gaze_B = Eigen::Vector3d::Zero();  ///< where to look, in the base frame [m]
  double remaining_m = 0;                            ///< to the goal; 0 without one
  std::string reason;                                ///< one line for people and logs
};

/// Drives to a goal round what the cameras see.
///
/// The paper's rule (Chessa et al. 2014, "Navigation"): the image is cut into a left, a central and
/// a right area. When a region in the central one is nearer than a limit, the robot heads for an
/// intermediate waypoint at +-pi/10 of its heading, on the side whose nearest thing is further, at
/// a distance proportional to the remaining one. A new obstacle overwrites the waypoint; once it is
/// reached the goal counts again.
///
/// Additions, each with its own setting in NavigatorConfig:
/// - Corridor test: "central" is the strip of ground that the robot would sweep on its way to the
///   current target, not a part of the image.
/// - Memory: what has left the narrow view still stands there for a while. What one view alone has
///   seen far away is kept clear of, but neither avoided nor planned round further on.
/// - Target in front: what lies beyond the current target is not in its way.
/// - Stop distance: never forward into something near ahead; only turning is left, and the next
///   view moves the waypoint on to the freer side.
/// - Free direction: not +-pi/10 alone but its multiples are tried, each as far as it is free; the
///   one with the shortest way to the goal through what is known is taken (ShortestDetour).
/// - Side hold: the side is changed only for a clearly freer one, so that the robot does not
/// dither.
/// - Blind: no motion before the first view or with one that is too old.
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
  void SetGoal(const Eigen::Vector2d& p_OG, std::optional<double> tolerance_m = {});

  /// A view has been processed. May come late: `X_OB` is where odometry had the base when the
  /// images were taken.
  /// @throws std::invalid_argument when the maps differ in size, or the view is older than the last
  void OnView(const SceneView& view, const hardware::Pose2& X_OB);

  /// One step of control. @param t does not decrease
  NavigatorDecision Update(hardware::Time t, const hardware::Pose2& X_OB);

 private:
  struct Progress {
    double best_remaining_m = 0;
    hardware::Time since{};
  };

  Eigen::Vector2d CurrentTarget() const;
  /// What is in the way to the current target and beside it, for a view taken at X_OB.
  StripMeasurements LookAhead(const SceneView& view, const hardware::Pose2& X_OB) const;
  void Avoid(const StripMeasurements& seen, const hardware::Pose2& X_OB);
  Detour ChooseDetour(const StripMeasurements& seen, const hardware::Pose2& X_OB,
                      double distance_m) const;
  /// kLeft or kRight.
  Strip ChooseSide(const StripMeasurements& seen, const hardware::Pose2& X_OB) const;
  void LeaveReachedWaypoint(const hardware::Pose2& X_OB);
  bool IsStuck(hardware::Time t, double remaining_m);
  bool IsBlind(hardware::Time t) const;
  /// Fills in command and state for driving to the current target.
  void Drive(hardware::Time t, const hardware::Pose2& X_OB, NavigatorDecision& decision);
  Eigen::Vector3d GazeTarget(const hardware::Pose2& X_OB) const;

  NavigatorConfig config_;
  WaypointController controller_;
  ObstacleMemory memory_;
  std::optional<Eigen::Vector2d> p_OG_;
  double goal_tolerance_m_ = 0;
  std::optional<hardware::Pose2> waypoint_;
  std::optional<Obstacle> obstacle_;
  std::string avoiding_why_;
  std::optional<Strip> side_;                      ///< held through one avoidance
  std::optional<Eigen::Vector2d> goal_leg_start_;  ///< where the last waypoint was reached, in O
  std::optional<hardware::Time> last_view_;
  std::optional<Progress> progress_;
  std::optional<NavigatorState> end_;  ///< kReached or kStuck once it came to that
};

}  // namespace horopter::control
