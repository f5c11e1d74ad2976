// SPDX-License-Identifier: Apache-2.0
#include "sim/koala/koala_plant.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "hardware/types/config_error.h"
#include "hardware/types/field_checker.h"

namespace horopter::sim {

namespace {

std::vector<hardware::FieldError> Validate(const KoalaPlantConfig& config) {
  hardware::FieldChecker check("koala.");
  check.Positive("metres_per_pulse", config.metres_per_pulse);
  check.Positive("pulses_per_turn", config.pulses_per_turn);
  check.Positive("max_wheel_speed_m_s", config.max_wheel_speed_m_s);
  check.Positive("max_wheel_acceleration_m_s2", config.max_wheel_acceleration_m_s2);
  check.Positive("deadman_s", hardware::ToSeconds(config.deadman));
  return check.Take();
}

double Ramp(double from, double to, double most) {
  return from + std::clamp(to - from, -most, most);
}

}  // namespace

KoalaPlant::KoalaPlant(World& world, const KoalaPlantConfig& config)
    : world_(world),
      config_(config),
      proximity_(world),
      wheels_{FindWheel(hardware::Eye::kLeft), FindWheel(hardware::Eye::kRight)} {
  hardware::ThrowIfAny(Validate(config));
  const int joint = world.model().body_jntadr[world.Id(mjOBJ_BODY, "base")];
  if (joint < 0 || world.model().jnt_type[joint] != mjJNT_FREE) {
    throw SceneError(
        fmt::format("scene '{}': body 'base' needs a <freejoint/>", world.path().string()));
  }
  base_velocity_index_ = world.model().jnt_dofadr[joint];
  last_command_ = world.now();
  SetEncoders({});
}

KoalaPlant::Wheel KoalaPlant::FindWheel(hardware::Eye side) const {
  const std::string name = hardware::ToString(side);
  const mjModel& model = world_.model();
  const int joint = world_.Id(mjOBJ_JOINT, name + "_middle_wheel");
  Wheel wheel;
  wheel.actuator = world_.Id(mjOBJ_ACTUATOR, name + "_drive");
  wheel.position_index = model.jnt_qposadr[joint];
  wheel.velocity_index = model.jnt_dofadr[joint];
  const double gain = model.actuator_gainprm[mjNGAIN * wheel.actuator];
  if (!(gain > 0) || !model.actuator_forcelimited[wheel.actuator]) {
    throw SceneError(fmt::format(
        "scene '{}': actuator '{}_drive' must be a <velocity> servo with kv and forcerange",
        world_.path().string(), name));
  }
  wheel.most_trim_rad_s = model.actuator_forcerange[2 * wheel.actuator + 1] / gain;
  return wheel;
}

void KoalaPlant::Command(const hardware::WheelSpeeds& speeds) {
  if (!std::isfinite(speeds.left_m_s) || !std::isfinite(speeds.right_m_s)) {
    throw std::invalid_argument(fmt::format("wheel speeds {} and {} m/s: must be finite",
                                            speeds.left_m_s, speeds.right_m_s));
  }
  const double fastest = std::max(std::abs(speeds.left_m_s), std::abs(speeds.right_m_s));
  const double scale =
      fastest > config_.max_wheel_speed_m_s ? config_.max_wheel_speed_m_s / fastest : 1;
  target_ = {scale * speeds.left_m_s, scale * speeds.right_m_s};
  last_command_ = world_.now();
}

void KoalaPlant::Update() {
  if (world_.now() - last_command_ >= config_.deadman) target_ = {};
  const double most = config_.max_wheel_acceleration_m_s2 * hardware::ToSeconds(world_.step());
  set_point_.left_m_s = Ramp(set_point_.left_m_s, target_.left_m_s, most);
  set_point_.right_m_s = Ramp(set_point_.right_m_s, target_.right_m_s, most);
  Drive(wheels_.left, set_point_.left_m_s);
  Drive(wheels_.right, set_point_.right_m_s);
}

void KoalaPlant::Drive(Wheel& wheel, double speed_m_s) {
  // The servo is the controller's proportional part; the integral part removes what is left under
  // load, up to the speed error at which the servo's torque reaches its limit.
  constexpr double kIntegralRate_per_s = 20;
  const double wanted_rad_s =
      speed_m_s * 2 * M_PI / (config_.metres_per_pulse * config_.pulses_per_turn);
  const double error_rad_s = wanted_rad_s - world_.data().qvel[wheel.velocity_index];
  wheel.trim_rad_s += kIntegralRate_per_s * error_rad_s * hardware::ToSeconds(world_.step());
  wheel.trim_rad_s = std::clamp(wheel.trim_rad_s, -wheel.most_trim_rad_s, wheel.most_trim_rad_s);
  world_.mutable_data().ctrl[wheel.actuator] = wanted_rad_s + wheel.trim_rad_s;
}

std::int64_t KoalaPlant::Pulses(const Wheel& wheel) const {
  const double turned = world_.data().qpos[wheel.position_index] - wheel.zero_rad;
  return std::llround(turned / (2 * M_PI) * config_.pulses_per_turn);
}

WheelPulses KoalaPlant::Encoders() const { return {Pulses(wheels_.left), Pulses(wheels_.right)}; }

void KoalaPlant::SetEncoders(const WheelPulses& counts) {
  const auto zero = [this](const Wheel& wheel, std::int64_t count) {
    return world_.data().qpos[wheel.position_index] -
           static_cast<double>(count) / config_.pulses_per_turn * 2 * M_PI;
  };
  wheels_.left.zero_rad = zero(wheels_.left, counts.left);
  wheels_.right.zero_rad = zero(wheels_.right, counts.right);
}

hardware::Pose2 KoalaPlant::TruePose() const { return hardware::ToPose2(world_.X_WBody("base")); }

hardware::Twist2 KoalaPlant::TrueTwist() const {
  // A free joint's linear velocity is in W, its angular velocity in the body's frame.
  const mjtNum* velocity = world_.data().qvel + base_velocity_index_;
  const double heading = TruePose().heading_rad;
  return {std::cos(heading) * velocity[0] + std::sin(heading) * velocity[1], velocity[5]};
}

}  // namespace horopter::sim
