// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "hardware/types/humanoid_state.h"
#include "sim/nao/joint_servos.h"
#include "sim/nao/planar_gait.h"
#include "sim/world/world.h"

namespace horopter::sim {

struct NaoPlantConfig {
  NaoGaitConfig gait;
  std::uint64_t seed = 1;  ///< of the feet's slip
};

/// NAO's body in a World: joint servos, standing, and walking by a planar gait.
///
/// Standing is physics: the servos hold the posture and the feet carry the weight; pushed hard, it
/// falls. Walking is not balanced. A PlanarGait says where the base and the feet are; a weld to the
/// mocap body "walker" carries the base there, sway included, and the legs follow by inverse
/// kinematics, so that the feet stand where they seem to stand. The weld is let go when the robot
/// stands again. The weld is stronger than what is in the way: once a part of the robot is pressed
/// 6 mm into it, the robot gives the walk up where it is, short of its target, and its legs are on
/// their own again.
///
/// The scene's bodies base (free) and walker, the weld "walker" and the joints are those of
/// scenes/nao/nao.xml.
class NaoPlant {
 public:
  /// The robot stands where the scene has it. `world` must outlive the plant.
  /// @throws SceneError when the scene has no NAO
  /// @throws hardware::ConfigError naming every bad field
  explicit NaoPlant(World& world, const NaoPlantConfig& config = {});

  /// Walking, by PlanarGait's rules. @pre finite, upright()
  void Move(const hardware::WalkVelocity& velocity) { gait_.Move(velocity); }
  void MoveTo(const hardware::Pose2& target) { gait_.MoveTo(target); }
  void Stop() { gait_.Move({}); }

  /// Advances gait and servos by one physics step, and keeps the head's pitch within its range at
  /// the present yaw. Call after VirtualHead::Update() and before World::Step().
  void Update();

  bool walking() const { return gait_.walking(); }
  /// Whether it has not fallen: the torso within 30 deg of upright and not on the ground.
  bool upright() const;

  const std::vector<hardware::HumanoidJoint>& joints() const { return servos_.joints(); }
  std::vector<double> JointPositions() const { return servos_.Positions(); }
  hardware::WalkVelocity max_velocity() const { return config_.gait.MaxVelocity(); }
  hardware::Duration max_stop_time() const;

  hardware::Pose2 Odometry() const { return gait_.odometry(); }
  void ResetOdometry() { gait_.ResetOdometry(); }

  /// The plan, sway included: for tests and reports.
  const PlanarGait& gait() const { return gait_; }

  /// Truth, for scoring and tests: planar pose of the base.
  hardware::Pose2 TruePose() const;

 private:
  void Carry();
  /// Whether something keeps the carried robot from where it should be.
  bool Blocked() const;
  void LetGo();
  void PoseLegs(const hardware::Pose& X_WB);
  void SwingArms();
  void GuardHead();

  World& world_;
  NaoPlantConfig config_;
  NaoJointServos servos_;
  PlanarGait gait_;
  int base_;  ///< body id
  int weld_;
  int walker_;          ///< mocap id
  int neck_pan_index_;  ///< in qpos
  int neck_pan_dof_;    ///< in qvel
  int neck_tilt_actuator_;
  double neck_lag_s_;
  bool carried_ = false;
  double carried_s_ = 0;               ///< for how long
  hardware::Pose X_PB_;                ///< base in the plan, when the weld took hold
  hardware::PerEye<double> shoulder_;  ///< pitch of a standing robot's
};

}  // namespace horopter::sim
