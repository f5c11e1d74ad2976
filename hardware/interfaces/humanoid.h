// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hardware/interfaces/device.h"
#include "hardware/types/humanoid_state.h"

namespace horopter::hardware {

/// A robot on two legs that walks by its own gait, told only where to.
///
/// Contract (besides Device's):
/// - Read() is allowed when inactive or active. Times do not decrease; the odometry is zero at the
///   first Configure() and at no other.
/// - Move() sets the walking velocity, MoveTo() the pose to walk to, relative to the pose that the
///   odometry states at the call. Both return at once and replace what was commanded before; the
///   gait takes a command up with its next step. A velocity beyond the robot's maximum is scaled
///   down in all components together, so that the path's shape is kept.
/// - MoveTo() ends standing at the target by the odometry, within a millimetre and a milliradian. A
///   robot that meets something on its way may end it anywhere; the odometry says where.
/// - Stop() ends walking with the fewest steps, at the latest after max_stop_time, and leaves the
///   robot standing; so does a Move() of zero. It never takes the joints' stiffness away: a robot
///   that stands falls without it. Stop() of a standing robot does nothing and succeeds.
/// - Move(), MoveTo() and Stop() are refused with kNotActive unless active; a velocity or target
///   that is not finite is refused whole with kOutOfRange. A robot that cannot stand refuses to
///   walk with kUnavailable.
/// - The robot has no deadman: it repeats the last command for ever. Whoever commands a Move() must
///   supply one, and call Stop() when its own commands cease. Deactivate() stops it as Stop() does.
class Humanoid : public Device {
 public:
  virtual Result<HumanoidState> Read() = 0;
  virtual Result<void> Move(const WalkVelocity& velocity) = 0;
  virtual Result<void> MoveTo(const Pose2& target) = 0;
  virtual Result<void> Stop() = 0;
  virtual HumanoidProperties properties() const = 0;
};

}  // namespace horopter::hardware
