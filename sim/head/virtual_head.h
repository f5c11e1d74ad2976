// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "hardware/types/head_angles.h"
#include "hardware/types/time.h"
#include "sim/faults/axis_faults.h"
#include "sim/head/axis_servo.h"
#include "sim/random/random_stream.h"
#include "sim/world/world.h"

namespace horopter::sim {

struct VirtualHeadConfig {
  /// Per axis; used for the axes that the scene has. Angles, speeds and accelerations are the
  /// controller's set limits, within what the joints allow.
  hardware::HeadLimits limits{};
  /// Size of an encoder step; 0: continuous. PTU-46: 185.1428 arc seconds.
  double encoder_resolution_rad = 0;
  /// Standard deviation of what is added before quantising; 0: none.
  double encoder_noise_rad = 0;
  std::uint64_t seed = 0;
  /// What is wrong with the head; those that are not about an axis are passed over.
  std::vector<Fault> faults{};
  /// The world's time at time zero of the run, on which the faults' times count.
  hardware::Duration time_zero{};
};

/// A stereo head in a World: motion profiles for its axes, and their encoders.
///
/// An axis exists when the scene has a hinge joint of its name (hardware::kHeadAxisNames: left_pan,
/// neck_tilt, ...), driven by a position actuator of the same name; others are ignored. Signs are
/// those of hardware::HeadAngles, which the joints must share: pan positive left, tilt positive
/// down. The actuators make the joints lag their set points by less than 1 deg in motion. Faults
/// come between motor, eye and encoder (sim/faults/axis_faults.h).
class VirtualHead {
 public:
  /// Starts at rest where the joints are. `world` must outlive the head.
  /// @throws SceneError when an axis has a joint but no position actuator, or there is no axis
  /// @throws hardware::ConfigError when limits are bad or beyond a joint's range, or a fault is bad
  ///         or of an axis that the scene lacks
  VirtualHead(World& world, const VirtualHeadConfig& config);

  /// Sets the targets, clamped to the limits. @pre finite
  void Command(const hardware::HeadAngles& target);

  /// Advances the profiles by one physics step and sets the actuators. Call before World::Step().
  void Update();

  /// Limits per axis; [0, 0] for those that the scene lacks.
  const hardware::HeadLimits& limits() const { return limits_; }

  /// Where the joints are.
  hardware::HeadAngles TrueAngles() const;
  /// Where the profiles want the motors now: the joints too, but for faults.
  hardware::HeadAngles SetPoint() const;
  /// What the encoders say: faults, noise, then rounding to whole steps. Draws new noise at every
  /// call.
  hardware::HeadAngles ReadEncoders();

  /// Whether every profile has reached its target.
  bool AtTarget() const;

 private:
  struct Axis {
    AxisServo servo;
    int position_index;  ///< in qpos
    int actuator;
    double lag_s;  ///< by which the joint follows a set point: damping over stiffness
    RandomStream noise;
    AxisFaults faults;
  };
  /// @throws hardware::ConfigError when a fault is of an axis that is not there
  void RequireAxes(const VirtualHeadConfig& config) const;
  /// Motor and eye of one axis, a step on.
  void Advance(Axis& axis, double dt_s);
  hardware::Time Now() const { return world_.now() - time_zero_; }
  std::optional<Axis> FindAxis(int axis, const VirtualHeadConfig& config) const;

  World& world_;
  hardware::Duration time_zero_;
  double encoder_resolution_;
  double encoder_noise_;
  hardware::HeadLimits limits_{};
  std::array<std::optional<Axis>, hardware::kHeadAxisCount> axes_;
};

}  // namespace horopter::sim
