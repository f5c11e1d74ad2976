// SPDX-License-Identifier: Apache-2.0
#include "sim/nao/joint_servos.h"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>

namespace horopter::sim {

namespace {

std::string SceneName(const std::string& joint) {
  if (joint == "HeadYaw") return "neck_pan";
  if (joint == "HeadPitch") return "neck_tilt";
  return joint;
}

bool IsPositionServo(const mjModel& model, int actuator, int joint) {
  return model.actuator_trntype[actuator] == mjTRN_JOINT &&
         model.actuator_trnid[2 * actuator] == joint &&
         model.actuator_biastype[actuator] == mjBIAS_AFFINE &&
         model.actuator_gainprm[mjNGAIN * actuator] > 0;
}

}  // namespace

const std::vector<std::string>& NaoJointNames() {
  static const std::vector<std::string> kNames = [] {
    std::vector<std::string> names = {"HeadYaw", "HeadPitch"};
    const auto arm = [&names](const std::string& side) {
      for (const char* joint :
           {"ShoulderPitch", "ShoulderRoll", "ElbowYaw", "ElbowRoll", "WristYaw", "Hand"}) {
        names.push_back(side + joint);
      }
    };
    const auto leg = [&names](const std::string& side) {
      for (const char* joint : {"HipRoll", "HipPitch", "KneePitch", "AnklePitch", "AnkleRoll"}) {
        names.push_back(side + joint);
      }
    };
    arm("L");
    names.push_back("LHipYawPitch");
    leg("L");
    leg("R");
    arm("R");
    return names;
  }();
  return kNames;
}

NaoJointServos::NaoJointServos(World& world) : world_(world) {
  const mjModel& model = world.model();
  for (const std::string& name : NaoJointNames()) {
    const std::string scene_name = SceneName(name);
    const int joint = world.Id(mjOBJ_JOINT, scene_name);
    const int actuator = world.Id(mjOBJ_ACTUATOR, scene_name);
    if (!IsPositionServo(model, actuator, joint) || !model.jnt_limited[joint] ||
        model.nuser_actuator < 1 || !(model.actuator_user[actuator * model.nuser_actuator] > 0)) {
      throw SceneError(fmt::format(
          "scene '{0}': NAO's joint '{1}' needs a range and <position name=\"{1}\" joint=\"{1}\" "
          "user=\"greatest speed\"/>",
          world.path().string(), scene_name));
    }
    const mjtNum* range = model.jnt_range + 2 * joint;
    joints_.push_back(
        {name, range[0], range[1], model.actuator_user[actuator * model.nuser_actuator]});
    const int position_index = model.jnt_qposadr[joint];
    const double position = world.data().qpos[position_index];
    servos_.push_back(
        {position_index, actuator,
         model.dof_damping[model.jnt_dofadr[joint]] / model.actuator_gainprm[mjNGAIN * actuator],
         scene_name != name, position, position});
    world.mutable_data().ctrl[actuator] = position;
  }
}

std::size_t NaoJointServos::Index(std::string_view joint) const {
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    if (joints_[i].name == joint) return i;
  }
  throw std::invalid_argument(fmt::format("NAO has no joint '{}'", joint));
}

void NaoJointServos::SetTarget(std::string_view joint, double target) {
  const std::size_t i = Index(joint);
  servos_[i].target = std::clamp(target, joints_[i].min_rad, joints_[i].max_rad);
}

void NaoJointServos::Update() {
  const double dt_s = hardware::ToSeconds(world_.step());
  mjtNum* ctrl = world_.mutable_data().ctrl;
  for (std::size_t i = 0; i < servos_.size(); ++i) {
    Servo& servo = servos_[i];
    if (servo.head) continue;
    const double most = joints_[i].max_speed_rad_s * dt_s;
    const double change = std::clamp(servo.target - servo.set_point, -most, most);
    // The servo pulls from where the joint is before the step, but is damped by the speed after it.
    ctrl[servo.actuator] = servo.set_point + servo.lag_s * change / dt_s;
    servo.set_point += change;
  }
}

std::vector<double> NaoJointServos::Positions() const {
  std::vector<double> positions;
  for (const Servo& servo : servos_) positions.push_back(world_.data().qpos[servo.position_index]);
  return positions;
}

}  // namespace horopter::sim
