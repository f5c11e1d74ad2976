// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "hardware/types/humanoid_state.h"
#include "sim/world/world.h"

namespace horopter::sim {

/// NAOqi's names of the H25's 25 joints, in the order in which it lists the body. LHipYawPitch
/// moves both legs. HeadYaw and HeadPitch are the scene's joints neck_pan and neck_tilt.
const std::vector<std::string>& NaoJointNames();

/// The position servos of a NAO in a World: a set point per joint that follows its target no faster
/// than the joint can, within its range. The head's two follow sim/head's profiles instead.
class NaoJointServos {
 public:
  /// Targets are where the joints are. `world` must outlive the servos.
  /// @throws SceneError when the scene has no NAO, or a joint lacks its servo, range or speed
  explicit NaoJointServos(World& world);

  /// Range and speed of every joint, as the scene states them, in the order of NaoJointNames().
  const std::vector<hardware::HumanoidJoint>& joints() const { return joints_; }

  /// Sets where a joint shall go, clamped to its range. @pre finite; not of the head
  void SetTarget(std::string_view joint, double target);

  /// Moves the set points on by one physics step. Call before World::Step().
  void Update();

  /// By how much a joint in motion follows its control value later: damping over stiffness [s].
  double Lag(std::string_view joint) const { return servos_[Index(joint)].lag_s; }

  /// Where the joints are, in the order of NaoJointNames().
  std::vector<double> Positions() const;

 private:
  struct Servo {
    int position_index;  ///< in qpos
    int actuator;
    double lag_s;
    bool head;
    double target;
    double set_point;
  };

  std::size_t Index(std::string_view joint) const;

  World& world_;
  std::vector<hardware::HumanoidJoint> joints_;
  std::vector<Servo> servos_;
};

}  // namespace horopter::sim
