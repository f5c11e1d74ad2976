// SPDX-License-Identifier: Apache-2.0
#include "control/navigator/navigator.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace horopter::control {

using hardware::Pose2;
using hardware::Time;

namespace {

Eigen::Vector2d Position(const Pose2& pose) { return {pose.x_m, pose.y_m}; }

double DistanceTo(const Pose2& X_OB, const Eigen::Vector2d& p_O) {
  return (p_O - Position(X_OB)).norm();
}

/// Direction of a point as the robot sees it, positive to the left.
double BearingTo(const Pose2& X_OB, const Eigen::Vector2d& p_O) {
  const Eigen::Vector2d d = p_O - Position(X_OB);
  return hardware::WrapAngle(std::atan2(d.y(), d.x()) - X_OB.heading_rad);
}

Eigen::Vector2d AtBearing(double bearing_rad, double distance_m) {
  return {distance_m * std::cos(bearing_rad), distance_m * std::sin(bearing_rad)};
}

std::string Metres(double distance) {
  if (std::isinf(distance)) return "free";
  char text[32];
  std::snprintf(text, sizeof text, "%.2f m", distance);
  return text;
}

std::string Name(const Obstacle& obstacle) {
  if (obstacle.label == Obstacle::kRemembered) return "something remembered";
  if (obstacle.label == 0) return "something without a region";
  return "region " + std::to_string(obstacle.label);
}

void CheckView(const SceneView& view, const std::optional<Time>& last) {
  if (view.regions.labels.size() != view.size() || view.floor_B.size() != view.size()) {
    throw std::invalid_argument("navigator: the view's labels and points differ in size");
  }
  if (last && view.t_capture < *last) {
    throw std::invalid_argument("navigator: the view of " +
                                std::to_string(hardware::ToSeconds(view.t_capture)) +
                                " s is older than the last one");
  }
}

}  // namespace

const char* ToString(NavigatorState state) {
  switch (state) {
    case NavigatorState::kIdle:
      return "idle";
    case NavigatorState::kBlind:
      return "blind";
    case NavigatorState::kDriving:
      return "driving";
    case NavigatorState::kAvoiding:
      return "avoiding";
    case NavigatorState::kTurning:
      return "turning";
    case NavigatorState::kReached:
      return "reached";
    case NavigatorState::kStuck:
      return "stuck";
  }
  return "?";
}

Navigator::Navigator(const NavigatorConfig& config)
    : config_((hardware::ThrowIfAny(config.Validate()), config)),
      controller_(config.controller),
      memory_(config.memory) {}

void Navigator::SetGoal(const Eigen::Vector2d& p_OG, std::optional<double> tolerance_m) {
  if (!p_OG.allFinite()) throw std::invalid_argument("navigator: the goal is not finite");
  const double tolerance = tolerance_m.value_or(config_.goal_tolerance_m);
  if (!(tolerance >= config_.controller.arrival_m)) {
    throw std::invalid_argument("navigator: the goal's tolerance of " + std::to_string(tolerance) +
                                " m is less than the controller's arrival_m");
  }
  p_OG_ = p_OG;
  goal_tolerance_m_ = tolerance;
  waypoint_.reset();
  obstacle_.reset();
  side_.reset();
  goal_leg_start_.reset();
  progress_.reset();
  end_.reset();
}

void Navigator::OnView(const SceneView& view, const Pose2& X_OB) {
  CheckView(view, last_view_);
  last_view_ = view.t_capture;
  memory_.Add(view, X_OB);
  if (!p_OG_ || end_) return;

  const StripMeasurements seen = LookAhead(view, X_OB);
  // What stands behind the current target, with room for the robot to stop there, is not in the
  // way to it.
  const double in_the_way =
      std::min(config_.obstacle_distance_m,
               DistanceTo(X_OB, CurrentTarget()) + config_.strips.corridor_half_width_m);
  if (seen.near_m(Strip::kCentre) < in_the_way) {
    Avoid(seen, X_OB);
  } else if (!waypoint_) {
    obstacle_.reset();
  }
}

Eigen::Vector2d Navigator::CurrentTarget() const {
  return waypoint_ ? Position(*waypoint_) : *p_OG_;
}

StripMeasurements Navigator::LookAhead(const SceneView& view, const Pose2& X_OB) const {
  const double bearing = BearingTo(X_OB, CurrentTarget());
  const StripMeasurements seen =
      MeasureStrips(view, config_.obstacle_test, bearing, config_.strips);
  if (config_.obstacle_test == ObstacleTest::kCentralImage) return seen;
  return Nearest(seen, MeasurePoints(memory_.PointsInBase(X_OB), bearing, config_.strips));
}

void Navigator::Avoid(const StripMeasurements& seen, const Pose2& X_OB) {
  const double distance = std::clamp(config_.avoid_fraction * DistanceTo(X_OB, *p_OG_),
                                     config_.avoid_min_m, config_.avoid_max_m);
  const Detour detour = ChooseDetour(seen, X_OB, distance);
  side_ = detour.side;
  obstacle_ = seen.centre;
  const double heading = hardware::WrapAngle(X_OB.heading_rad + detour.turn_rad);
  waypoint_ = Pose2{X_OB.x_m + detour.distance_m * std::cos(heading),
                    X_OB.y_m + detour.distance_m * std::sin(heading), heading};
  goal_leg_start_.reset();
  avoiding_why_ = Name(*obstacle_) + " " + Metres(obstacle_->near_m) + " ahead; left " +
                  Metres(seen.near_m(Strip::kLeft)) + ", right " +
                  Metres(seen.near_m(Strip::kRight)) + ": going " +
                  (*side_ == Strip::kLeft ? "left" : "right");
}

Detour Navigator::ChooseDetour(const StripMeasurements& seen, const Pose2& X_OB,
                               double distance_m) const {
  const Strip freer = ChooseSide(seen, X_OB);
  const double sign = freer == Strip::kLeft ? 1 : -1;
  const Detour papers{freer, sign * config_.avoid_angle_rad, distance_m};
  if (config_.avoid_directions == 1) return papers;

  const KnownGround known{memory_.PointsInBase(X_OB, ObstacleMemory::Certainty::kAny),
                          memory_.PointsInBase(X_OB)};
  const Eigen::Vector2d p_BG = AtBearing(BearingTo(X_OB, *p_OG_), DistanceTo(X_OB, *p_OG_));
  return ShortestDetour(known, p_BG, distance_m, freer, side_, config_).value_or(papers);
}

Strip Navigator::ChooseSide(const StripMeasurements& seen, const Pose2& X_OB) const {
  if (side_) {
    const double held = seen.near_m(*side_);
    const double other = seen.near_m(OtherSide(*side_));
    const bool leave =
        held < config_.obstacle_distance_m && other > config_.side_switch_ratio * held;
    return leave ? OtherSide(*side_) : *side_;
  }
  const double left = seen.near_m(Strip::kLeft);
  const double right = seen.near_m(Strip::kRight);
  if (left != right) return left > right ? Strip::kLeft : Strip::kRight;
  return BearingTo(X_OB, *p_OG_) >= 0 ? Strip::kLeft : Strip::kRight;
}

NavigatorDecision Navigator::Update(Time t, const Pose2& X_OB) {
  NavigatorDecision decision;
  decision.t = t;
  decision.gaze_B = GazeTarget(X_OB);
  if (!p_OG_) {
    decision.reason = "no goal";
    return decision;
  }
  decision.remaining_m = DistanceTo(X_OB, *p_OG_);
  if (!end_ && decision.remaining_m <= goal_tolerance_m_) end_ = NavigatorState::kReached;
  if (!end_ && IsBlind(t)) {
    // Waiting for a view is not being stuck.
    progress_.reset();
    decision.state = NavigatorState::kBlind;
    decision.reason = last_view_ ? "the last view is too old" : "no view yet";
    return decision;
  }
  if (!end_ && IsStuck(t, decision.remaining_m)) end_ = NavigatorState::kStuck;
  if (end_) {
    decision.state = *end_;
    decision.obstacle = obstacle_;
    decision.reason = *end_ == NavigatorState::kReached
                          ? "at the goal"
                          : "no nearer to the goal for " +
                                std::to_string(static_cast<int>(config_.stuck_after_s)) + " s";
    return decision;
  }
  LeaveReachedWaypoint(X_OB);
  Drive(t, X_OB, decision);
  decision.gaze_B = GazeTarget(X_OB);
  decision.waypoint = waypoint_;
  decision.obstacle = obstacle_;
  return decision;
}

bool Navigator::IsBlind(Time t) const {
  return !last_view_ || hardware::ToSeconds(t - *last_view_) > config_.max_view_age_s;
}

bool Navigator::IsStuck(Time t, double remaining_m) {
  if (!progress_ || remaining_m < progress_->best_remaining_m - config_.stuck_progress_m) {
    progress_ = Progress{remaining_m, t};
  }
  return hardware::ToSeconds(t - progress_->since) > config_.stuck_after_s;
}

void Navigator::LeaveReachedWaypoint(const Pose2& X_OB) {
  if (waypoint_ && DistanceTo(X_OB, Position(*waypoint_)) <= config_.waypoint_tolerance_m) {
    waypoint_.reset();
    goal_leg_start_ = Position(X_OB);
  }
  if (!waypoint_ && side_ && goal_leg_start_ &&
      DistanceTo(X_OB, *goal_leg_start_) >= config_.side_hold_m) {
    side_.reset();
    obstacle_.reset();
  }
}

void Navigator::Drive(Time t, const Pose2& X_OB, NavigatorDecision& decision) {
  const Eigen::Vector2d target = CurrentTarget();
  controller_.SetTarget(target);
  const WaypointController::Output out = controller_.Update(t, X_OB);
  decision.command = out.command;
  decision.state = out.turning_in_place ? NavigatorState::kTurning
                   : waypoint_          ? NavigatorState::kAvoiding
                                        : NavigatorState::kDriving;
  decision.reason = waypoint_ ? avoiding_why_ : "to the goal";

  const double ahead =
      MeasurePoints(memory_.PointsInBase(X_OB), 0, config_.strips).near_m(Strip::kCentre);
  // Close to the target it is the target that ends the motion, not what stands beyond.
  const double stop =
      std::min(config_.stop_distance_m, out.distance_m + config_.strips.corridor_half_width_m);
  if (ahead < stop && !out.turning_in_place) {
    decision.command.forward_m_s = 0;
    decision.state = NavigatorState::kTurning;
    decision.reason = "stopped: something " + Metres(ahead) + " ahead; " + decision.reason;
  } else if (ahead < config_.slow_distance_m) {
    // A quarter is left at the stop distance, so that the robot does not creep up to it.
    const double part = (ahead - stop) / (config_.slow_distance_m - stop);
    decision.command.forward_m_s *= 0.25 + 0.75 * std::clamp(part, 0.0, 1.0);
  }
}

Eigen::Vector3d Navigator::GazeTarget(const Pose2& X_OB) const {
  double bearing = 0;
  double distance = config_.gaze_max_m;
  if (p_OG_) {
    const Eigen::Vector2d target = CurrentTarget();
    bearing = std::clamp(BearingTo(X_OB, target), -config_.gaze_max_bearing_rad,
                         config_.gaze_max_bearing_rad);
    distance = std::clamp(DistanceTo(X_OB, target), config_.gaze_min_m, config_.gaze_max_m);
  }
  return {distance * std::cos(bearing), distance * std::sin(bearing), config_.gaze_height_m};
}

}  // namespace horopter::control
