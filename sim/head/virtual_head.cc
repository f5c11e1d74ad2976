// SPDX-License-Identifier: Apache-2.0
#include "sim/head/virtual_head.h"

#include <fmt/core.h>

#include <cmath>
#include <string>

#include "hardware/types/config_error.h"

namespace horopter::sim {

namespace {

/// Degrees are written to few digits in scenes and robot descriptions.
constexpr double kRangeSlack_rad = 1e-6;

void RequireWithin(const mjModel& model, int joint, const std::string& name,
                   const hardware::AxisLimits& limits) {
  if (!model.jnt_limited[joint]) return;
  const mjtNum* range = model.jnt_range + 2 * joint;
  if (limits.min_rad < range[0] - kRangeSlack_rad || limits.max_rad > range[1] + kRangeSlack_rad) {
    throw hardware::ConfigError(
        {{"head." + name, fmt::format("[{:.4f}, {:.4f}] rad", limits.min_rad, limits.max_rad),
          fmt::format("must lie within the joint's range [{:.4f}, {:.4f}] rad", range[0],
                      range[1])}});
  }
}

int PositionActuator(const mjModel& model, int joint, const std::string& name) {
  const int actuator = mj_name2id(&model, mjOBJ_ACTUATOR, name.c_str());
  if (actuator < 0 || model.actuator_trntype[actuator] != mjTRN_JOINT ||
      model.actuator_trnid[2 * actuator] != joint ||
      model.actuator_biastype[actuator] != mjBIAS_AFFINE) {
    throw SceneError(fmt::format(
        "head axis '{0}': the scene needs <position name=\"{0}\" joint=\"{0}\"/>", name));
  }
  return actuator;
}

}  // namespace

VirtualHead::VirtualHead(World& world, const VirtualHeadConfig& config)
    : world_(world),
      time_zero_(config.time_zero),
      encoder_resolution_(config.encoder_resolution_rad),
      encoder_noise_(config.encoder_noise_rad) {
  if (!(encoder_resolution_ >= 0) || !(encoder_noise_ >= 0)) {
    throw hardware::ConfigError(
        {{"head.encoder_resolution_rad, encoder_noise_rad",
          fmt::format("{}, {}", encoder_resolution_, encoder_noise_), "must not be negative"}});
  }
  hardware::ThrowIfAny(Validate(config.faults));
  bool any = false;
  for (int i = 0; i < hardware::kHeadAxisCount; ++i) {
    axes_[i] = FindAxis(i, config);
    if (axes_[i]) limits_[i] = config.limits[i];
    any = any || axes_[i].has_value();
  }
  if (!any) {
    throw SceneError(
        fmt::format("scene '{}' has no head: no joint is named left_pan, neck_pan, ...",
                    world.path().string()));
  }
  RequireAxes(config);
}

void VirtualHead::RequireAxes(const VirtualHeadConfig& config) const {
  std::vector<hardware::FieldError> errors;
  for (int i = 0; i < hardware::kHeadAxisCount; ++i) {
    const auto axis = static_cast<hardware::HeadAxis>(i);
    if (axes_[i] || AxisFaults(config.faults, axis, config.seed).none()) continue;
    errors.push_back({"faults", std::string(hardware::kHeadAxisNames[i]),
                      "is an axis that the scene's head does not have"});
  }
  hardware::ThrowIfAny(std::move(errors));
}

std::optional<VirtualHead::Axis> VirtualHead::FindAxis(int axis,
                                                       const VirtualHeadConfig& config) const {
  const mjModel& model = world_.model();
  const std::string name(hardware::kHeadAxisNames[axis]);
  const int joint = mj_name2id(&model, mjOBJ_JOINT, name.c_str());
  if (joint < 0) return std::nullopt;
  RequireWithin(model, joint, name, config.limits[axis]);
  const int actuator = PositionActuator(model, joint, name);
  const int position_index = model.jnt_qposadr[joint];
  const double stiffness = model.actuator_gainprm[mjNGAIN * actuator];
  const double damping = model.dof_damping[model.jnt_dofadr[joint]];
  return Axis{AxisServo(config.limits[axis], world_.data().qpos[position_index]),
              position_index,
              actuator,
              stiffness > 0 ? damping / stiffness : 0,
              RandomStream(config.seed, "head." + name + ".encoder"),
              AxisFaults(config.faults, static_cast<hardware::HeadAxis>(axis), config.seed)};
}

void VirtualHead::Command(const hardware::HeadAngles& target) {
  const hardware::HeadAxisArray targets = hardware::ToArray(target);
  for (int i = 0; i < hardware::kHeadAxisCount; ++i) {
    if (axes_[i]) axes_[i]->servo.SetTarget(targets[i]);
  }
}

void VirtualHead::Update() {
  const double dt_s = hardware::ToSeconds(world_.step());
  for (std::optional<Axis>& axis : axes_) {
    if (axis) Advance(*axis, dt_s);
  }
}

void VirtualHead::Advance(Axis& axis, double dt_s) {
  const double position_rad = axis.servo.position_rad();
  if (axis.faults.Stuck(Now())) {
    const double target_rad = axis.servo.target_rad();
    axis.servo = AxisServo(axis.servo.limits(), position_rad);
    axis.servo.SetTarget(target_rad);
  } else {
    axis.servo.Advance(dt_s);
  }
  // The actuator pulls from where the joint is before the step, but is damped by the speed after
  // it.
  const AxisFaults::Load load = axis.faults.Follow(position_rad, axis.servo.speed_rad_s(), Now());
  world_.mutable_data().ctrl[axis.actuator] = load.position_rad + axis.lag_s * load.speed_rad_s;
}

hardware::HeadAngles VirtualHead::TrueAngles() const {
  hardware::HeadAxisArray angles{};
  for (int i = 0; i < hardware::kHeadAxisCount; ++i) {
    if (axes_[i]) angles[i] = world_.data().qpos[axes_[i]->position_index];
  }
  return hardware::FromArray(angles);
}

hardware::HeadAngles VirtualHead::SetPoint() const {
  hardware::HeadAxisArray angles{};
  for (int i = 0; i < hardware::kHeadAxisCount; ++i) {
    if (axes_[i]) angles[i] = axes_[i]->servo.position_rad();
  }
  return hardware::FromArray(angles);
}

hardware::HeadAngles VirtualHead::ReadEncoders() {
  hardware::HeadAxisArray angles = hardware::ToArray(TrueAngles());
  for (int i = 0; i < hardware::kHeadAxisCount; ++i) {
    if (!axes_[i]) continue;
    angles[i] = axes_[i]->faults.Read(angles[i], Now());
    if (encoder_noise_ > 0) angles[i] += encoder_noise_ * axes_[i]->noise.Gaussian();
    if (encoder_resolution_ > 0) {
      angles[i] = encoder_resolution_ * std::round(angles[i] / encoder_resolution_);
    }
  }
  return hardware::FromArray(angles);
}

bool VirtualHead::AtTarget() const {
  for (const std::optional<Axis>& axis : axes_) {
    if (axis && !axis->servo.at_target()) return false;
  }
  return true;
}

}  // namespace horopter::sim
