// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "hardware/types/config_error.h"
#include "hardware/types/eye.h"
#include "hardware/types/humanoid_state.h"
#include "hardware/types/pose.h"
#include "hardware/types/time.h"
#include "sim/random/random_stream.h"

namespace horopter::sim {

/// NAO's walk. Step limits are NAOqi's defaults (MaxStepX, MaxStepTheta, StepHeight, the clip of
/// the feet's distance at 0.16 m); the period is the one that makes them agree with the top speed
/// of 0.0952 m/s, at NAOqi's normalised frequency of 1. Sway and slip are set by us.
struct NaoGaitConfig {
  double step_period_s = 0.42;
  double max_step_forward_m = 0.04;  ///< of the body, per step
  double max_step_aside_m = 0.06;    ///< by which the feet open, and close with the next step
  double max_step_turn_rad = 0.35;   ///< likewise
  double step_height_m = 0.02;
  double sway_aside_m = 0.018;    ///< amplitude, towards the foot that stands; period: two steps
  double sway_roll_rad = 0.0175;  ///< amplitude, leaning towards the foot that stands
  double sway_up_m = 0.004;       ///< highest over the foot that stands; period: one step
  double slip_gain = 0.015;       ///< deviation of a run's constant error of each velocity
  double slip_step = 0.03;        ///< deviation of one step's error of its length
  double slip_turn_rad = 0.006;   ///< deviation of one step's turn

  /// The greatest velocity of each component.
  hardware::WalkVelocity MaxVelocity() const;
  std::vector<hardware::FieldError> Validate() const;
};

/// The planned motion of a walking NAO on a plane: where its feet and its body are, step by step.
///
/// The body follows the commanded velocity, which changes linearly during a step and is decided at
/// its beginning; a target is walked to on the arc of constant curvature that ends in it, with a
/// step to speed up and one to slow down. A stop takes one step to slow down and one to bring the
/// feet together. Each foot stands still while it carries; the other swings to where it will stand
/// halfway through its own step. Aside and in turns, the foot on that side leads and the other
/// follows, so that toes never turn inwards.
///
/// Two poses are kept: what the robot believes (odometry), and where its feet, which slip, take it.
class PlanarGait {
 public:
  /// @param tick the time that Advance() stands for; a step lasts a whole number of ticks
  /// @throws hardware::ConfigError naming every bad field
  PlanarGait(const NaoGaitConfig& config, std::uint64_t seed, hardware::Duration tick);

  /// Sets the velocity to walk with, scaled down to the maximum in all components together.
  void Move(const hardware::WalkVelocity& velocity);
  /// Sets a target relative to the odometry's pose now.
  void MoveTo(const hardware::Pose2& target);

  /// Whether there is something to walk for, or a step is under way.
  bool walking() const { return walking_; }
  /// Puts a standing robot somewhere, feet together: where it has been pushed to, or starts.
  /// @pre !walking()
  void StandAt(const hardware::Pose2& X_WB);

  void Advance();
  /// Something is in the way: the body stops at once, what was commanded is forgotten, and the
  /// robot steps back the way it came by a few centimetres. Does nothing while it steps back.
  void Recoil();

  /// Pose of the base, sway included, and of the feet's soles under the ankles, in W, on z = 0.
  hardware::Pose X_WB() const;
  hardware::Pose X_WF(hardware::Eye side) const;
  /// The foot that carries the robot; either when standing.
  hardware::Eye stance() const;
  /// Share of the present step that is done, in [0, 1); 0 when standing.
  double phase() const;
  /// From 0 when standing to 1 in full walk.
  double sway_envelope() const;

  const hardware::Pose2& odometry() const { return odometry_; }
  void ResetOdometry();

 private:
  using Velocity = Eigen::Vector3d;  ///< forward, left, turn
  struct Plan {
    Velocity velocity;
    int steps_left;
  };
  void BeginStep();
  Velocity NextVelocity();
  Velocity PlanTowards(const hardware::Pose2& goal);
  Velocity Slipped(const Velocity& v) const;
  hardware::Pose2 Landing() const;
  hardware::Pose2 Home(hardware::Eye side) const;
  hardware::Eye FirstSwing() const;

  NaoGaitConfig config_;
  double tick_s_;
  int ticks_per_step_;
  double step_s_;
  RandomStream random_;
  Velocity run_gain_;

  Velocity wanted_ = Velocity::Zero();
  std::optional<hardware::Pose2> goal_;  ///< in the odometry's frame
  std::optional<Plan> plan_;

  bool walking_ = false;
  bool recoiling_ = false;
  bool first_step_ = false;
  int tick_ = 0;
  int still_steps_ = 0;  ///< steps begun one after the other with nothing left to walk for
  Velocity from_ = Velocity::Zero();
  Velocity to_ = Velocity::Zero();
  Velocity step_gain_ = Velocity::Ones();
  double step_turn_rad_s_ = 0;
  hardware::Eye swing_ = hardware::Eye::kRight;
  hardware::Pose2 swing_from_;
  hardware::Pose2 swing_to_;
  hardware::PerEye<hardware::Pose2> foot_;
  hardware::Pose2 odometry_;
  hardware::Pose2 actual_;
};

}  // namespace horopter::sim
