// SPDX-License-Identifier: Apache-2.0
#include "sim/nao/nao_plant.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "sim/nao/head_limits.h"
#include "sim/nao/leg_ik.h"

namespace horopter::sim {

namespace {

using Eigen::Vector3d;
using hardware::Eye;
using hardware::Pose;

/// Of the standing robot in scenes/nao/nao.xml: the torso above the base, the ankles behind it.
constexpr double kTorsoHeight_m = 0.31719;
constexpr double kAnkleX_m = -0.01;

Pose Translated(double x, double y, double z) {
  Pose X = Pose::Identity();
  X.translation() << x, y, z;
  return X;
}

/// The part `share` of the way from no motion to X.
Pose Part(const Pose& X, double share) {
  Pose part = Pose::Identity();
  part.translation() = share * X.translation();
  const Eigen::AngleAxisd turn(X.linear());
  part.linear() = Eigen::AngleAxisd(share * turn.angle(), turn.axis()).toRotationMatrix();
  return part;
}

std::string Name(Eye side, const char* joint) {
  return (side == Eye::kLeft ? "L" : "R") + std::string(joint);
}

int FreeBase(const World& world) {
  const int base = world.Id(mjOBJ_BODY, "base");
  const int joint = world.model().body_jntadr[base];
  if (joint < 0 || world.model().jnt_type[joint] != mjJNT_FREE) {
    throw SceneError(
        fmt::format("scene '{}': body 'base' needs a <freejoint/>", world.path().string()));
  }
  return base;
}

int Walker(const World& world) {
  const int mocap = world.model().body_mocapid[world.Id(mjOBJ_BODY, "walker")];
  if (mocap < 0) {
    throw SceneError(
        fmt::format("scene '{}': body 'walker' needs mocap=\"true\"", world.path().string()));
  }
  return mocap;
}

}  // namespace

NaoPlant::NaoPlant(World& world, const NaoPlantConfig& config)
    : world_(world),
      config_(config),
      servos_(world),
      gait_(config.gait, config.seed, world.step()),
      base_(FreeBase(world)),
      weld_(world.Id(mjOBJ_EQUALITY, "walker")),
      walker_(Walker(world)),
      neck_pan_index_(world.model().jnt_qposadr[world.Id(mjOBJ_JOINT, "neck_pan")]),
      neck_pan_dof_(world.model().jnt_dofadr[world.Id(mjOBJ_JOINT, "neck_pan")]),
      neck_tilt_actuator_(world.Id(mjOBJ_ACTUATOR, "neck_tilt")),
      neck_lag_s_(servos_.Lag("HeadPitch")) {
  for (const Eye side : hardware::kBothEyes) {
    const int joint = world.Id(mjOBJ_JOINT, Name(side, "ShoulderPitch"));
    shoulder_[side] = world.data().qpos[world.model().jnt_qposadr[joint]];
  }
  LetGo();
  gait_.StandAt(TruePose());
}

void NaoPlant::Update() {
  if (!gait_.walking()) {
    if (carried_) LetGo();
    gait_.StandAt(TruePose());
  } else {
    gait_.Advance();
    if (carried_ && Blocked()) gait_.Recoil();
    if (gait_.walking()) Carry();
  }
  SwingArms();
  servos_.Update();
  GuardHead();
}

void NaoPlant::Carry() {
  const Pose X_WP = gait_.X_WB();
  if (!carried_) {
    X_PB_ = X_WP.inverse() * world_.X_WBody("base");
    carried_s_ = 0;
    carried_ = true;
    world_.mutable_model().eq_active[weld_] = 1;
  }
  // From where it stood into the plan during the first step; but it stays as high as it stood, so
  // that the feet carry the weight as before.
  carried_s_ += hardware::ToSeconds(world_.step());
  const double t = std::min(carried_s_ / config_.gait.step_period_s, 1.0);
  Pose X_PB = Part(X_PB_, 1 - t * t * (3 - 2 * t));
  X_PB.translation().z() = X_PB_.translation().z();
  const Pose X_WB = X_WP * X_PB;
  const Eigen::Quaterniond q = Eigen::Quaterniond(X_WB.linear()).normalized();
  mjData& data = world_.mutable_data();
  Eigen::Map<Vector3d>{data.mocap_pos + 3 * walker_} = X_WB.translation();
  Eigen::Map<Eigen::Vector4d>{data.mocap_quat + 4 * walker_} << q.w(), q.x(), q.y(), q.z();
  PoseLegs(X_WP);
}

bool NaoPlant::Blocked() const {
  constexpr double kDeepest_m = 0.006, kFarthest_m = 0.02;
  for (const Eye side : hardware::kBothEyes) {
    const Pose X_WA = gait_.X_WF(side) * Translated(kAnkleX_m, 0, NaoLeg::kFootHeight_m);
    const Pose X_WF = world_.X_WBody(side == Eye::kLeft ? "l_foot" : "r_foot");
    if ((X_WF.translation() - X_WA.translation()).norm() > kFarthest_m) return true;
  }
  const mjModel& model = world_.model();
  const mjData& data = world_.data();
  for (int i = 0; i < data.ncon; ++i) {
    const mjContact& contact = data.contact[i];
    const bool robot = model.body_rootid[model.geom_bodyid[contact.geom1]] == base_ ||
                       model.body_rootid[model.geom_bodyid[contact.geom2]] == base_;
    if (robot && contact.dist < -kDeepest_m) return true;
  }
  return false;
}

void NaoPlant::LetGo() {
  carried_ = false;
  world_.mutable_model().eq_active[weld_] = 0;
  // Legs as they are written down: upright, feet together.
  gait_.StandAt(TruePose());
  PoseLegs(gait_.X_WB());
}

void NaoPlant::PoseLegs(const Pose& X_WB) {
  const Pose X_WT = X_WB * Translated(0, 0, kTorsoHeight_m);
  hardware::PerEye<Pose> X_TF;
  for (const Eye side : hardware::kBothEyes) {
    X_TF[side] =
        X_WT.inverse() * gait_.X_WF(side) * Translated(kAnkleX_m, 0, NaoLeg::kFootHeight_m);
  }
  // One motor for both hips: the leg that carries decides.
  const double hip_yaw_pitch = SolveHipYawPitch(gait_.stance(), X_TF[gait_.stance()]);
  servos_.SetTarget("LHipYawPitch", hip_yaw_pitch);
  for (const Eye side : hardware::kBothEyes) {
    const LegAngles leg = SolveLeg(side, X_TF[side], hip_yaw_pitch);
    servos_.SetTarget(Name(side, "HipRoll"), leg.hip_roll);
    servos_.SetTarget(Name(side, "HipPitch"), leg.hip_pitch);
    servos_.SetTarget(Name(side, "KneePitch"), leg.knee_pitch);
    servos_.SetTarget(Name(side, "AnklePitch"), leg.ankle_pitch);
    servos_.SetTarget(Name(side, "AnkleRoll"), leg.ankle_roll);
  }
}

void NaoPlant::SwingArms() {
  // Each arm goes back with the foot of its side; they are for looks.
  constexpr double kSwing_rad = 0.15;
  const double stance = gait_.stance() == Eye::kLeft ? 1 : -1;
  const double wave =
      gait_.walking() ? stance * gait_.sway_envelope() * std::sin(M_PI * gait_.phase()) : 0;
  servos_.SetTarget("LShoulderPitch", shoulder_.left + kSwing_rad * wave);
  servos_.SetTarget("RShoulderPitch", shoulder_.right - kSwing_rad * wave);
}

void NaoPlant::GuardHead() {
  mjData& data = world_.mutable_data();
  // The joint follows its set point a little later; so the set point keeps the range ahead of it.
  const double yaw_rad = data.qpos[neck_pan_index_] + neck_lag_s_ * data.qvel[neck_pan_dof_];
  const PitchRange range = NaoPitchRange(yaw_rad);
  mjtNum& pitch = data.ctrl[neck_tilt_actuator_];
  pitch = std::clamp(pitch, range.min_rad, range.max_rad);
}

bool NaoPlant::upright() const {
  const Pose X_WT = world_.X_WBody("torso");
  constexpr double kMostLean_rad = M_PI / 6;
  return X_WT.linear()(2, 2) > std::cos(kMostLean_rad) &&
         X_WT.translation().z() > kTorsoHeight_m / 2;
}

hardware::Duration NaoPlant::max_stop_time() const {
  // The step under way, one to slow down, one to bring the feet together; and a tick to notice.
  return hardware::FromSeconds(3 * config_.gait.step_period_s) + 2 * world_.step();
}

hardware::Pose2 NaoPlant::TruePose() const { return hardware::ToPose2(world_.X_WBody("base")); }

}  // namespace horopter::sim
