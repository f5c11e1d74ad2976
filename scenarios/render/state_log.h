// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

#include "hardware/types/head_angles.h"
#include "hardware/types/pose.h"
#include "hardware/types/time.h"
#include "sim/truth/world_state.h"
#include "sim/world/world.h"

namespace horopter::scenarios {

/// The head's axes as a state has them, by the names of their joints; those that are not there are
/// 0.
struct HeadMotion {
  hardware::HeadAngles angles;
  hardware::HeadAxisArray speed_rad_s{};
};
HeadMotion HeadIn(const sim::WorldState& state);

/// The true states of a moving robot: all since the newest frame's capture, for looking up what was
/// when a later frame was taken; and of every physics step a row of a table.
class StateLog {
 public:
  /// Names of the table's columns: t_s, the robot's body "base" in its starting frame O (yaw about
  /// the vertical, then pitch, then roll), then angle and speed of every axis of the head.
  static std::string Header();

  /// @param X_WO the robot's starting frame
  explicit StateLog(const hardware::Pose& X_WO) : X_OW_(X_WO.inverse()) {}

  /// @pre t later than all before
  void Record(hardware::Time t, const sim::World& world);

  /// The state at t, or at the last instant before it that was recorded; the first one when there
  /// is none, since a robot that has not started yet rests. @pre something was recorded
  const sim::WorldState& At(hardware::Time t) const;

  /// Forgets what is before the state at t.
  void ForgetBefore(hardware::Time t);

  /// Rows since the last call, without a line end after the last.
  std::string TakeRows();

 private:
  hardware::Pose X_OW_;
  std::map<hardware::Time, sim::WorldState> states_;
  std::string rows_;
};

}  // namespace horopter::scenarios
