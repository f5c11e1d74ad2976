// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "hardware/types/base_state.h"
#include "hardware/types/eye.h"
#include "hardware/types/pose.h"
#include "hardware/types/time.h"
#include "sim/koala/proximity.h"
#include "sim/world/world.h"

namespace horopter::sim {

/// The real Koala's numbers (K-Team); the scene's wheels and motors match them.
struct KoalaPlantConfig {
  double metres_per_pulse = 0.045e-3;
  double pulses_per_turn = 5850;
  double max_wheel_speed_m_s = 0.5715;  ///< 127 speed units of 4.5 mm/s
  double max_wheel_acceleration_m_s2 = 1.0;
  hardware::Duration deadman = hardware::FromSeconds(0.5);
};

/// Encoder counts of the driven wheels.
struct WheelPulses {
  std::int64_t left = 0;
  std::int64_t right = 0;
};

/// The Koala's base in a World: motor controller, encoders, proximity sensors.
///
/// The controller ramps each wheel to its commanded speed and holds it (PI) through the scene's
/// velocity servos (actuators left_drive and right_drive, joints left_middle_wheel and
/// right_middle_wheel, free body base), whose torque is limited. Where the robot goes is up to
/// contact physics.
class KoalaPlant {
 public:
  /// `world` must outlive the plant. @throws SceneError when the scene has no Koala
  /// @throws hardware::ConfigError naming every bad field
  explicit KoalaPlant(World& world, const KoalaPlantConfig& config = {});

  /// Sets the speeds to hold. Beyond the maximum both are scaled down together, which keeps the
  /// path's curvature. @throws std::invalid_argument when not finite, with no effect.
  void Command(const hardware::WheelSpeeds& speeds);

  /// Advances the controller by one physics step. Call before World::Step(). When the last command
  /// is older than the deadman period, the wheels ramp down to rest.
  void Update();

  /// Counts since construction or SetEncoders(), unwrapped.
  WheelPulses Encoders() const;
  void SetEncoders(const WheelPulses& counts);

  std::array<int, kKoalaProximityCount> Proximity() const { return proximity_.Read(world_); }

  /// Speeds that the controller holds now, ramps included.
  const hardware::WheelSpeeds& set_point() const { return set_point_; }

  /// Truth, for scoring and tests: pose and velocity of the base on the ground plane.
  hardware::Pose2 TruePose() const;
  hardware::Twist2 TrueTwist() const;

 private:
  struct Wheel {
    int actuator = 0;
    int position_index = 0;      ///< in qpos
    int velocity_index = 0;      ///< in qvel
    double most_trim_rad_s = 0;  ///< speed error that asks for the motor's greatest torque
    double zero_rad = 0;         ///< where the encoder reads zero
    double trim_rad_s = 0;       ///< the controller's integral part
  };
  Wheel FindWheel(hardware::Eye side) const;
  void Drive(Wheel& wheel, double speed_m_s);
  std::int64_t Pulses(const Wheel& wheel) const;

  World& world_;
  KoalaPlantConfig config_;
  KoalaProximity proximity_;
  hardware::PerEye<Wheel> wheels_;
  int base_velocity_index_;  ///< in qvel
  hardware::WheelSpeeds target_;
  hardware::WheelSpeeds set_point_;
  hardware::Time last_command_{};
};

}  // namespace horopter::sim
