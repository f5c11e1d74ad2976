// SPDX-License-Identifier: Apache-2.0
#include "sim/backend/sim_humanoid.h"

#include <cmath>
#include <string>

namespace horopter::sim {

using hardware::Error;
using hardware::ErrorCode;
using hardware::Result;

Result<hardware::HumanoidState> SimHumanoid::Read() {
  if (const auto allowed = Require("Read", true); !allowed.ok()) return allowed.error();
  return hardware::HumanoidState{clock_.Now(), plant_.JointPositions(), plant_.Odometry(),
                                 plant_.walking()};
}

Result<void> SimHumanoid::MayWalk(const char* call, double a, double b, double c) const {
  if (const auto allowed = Require(call, false); !allowed.ok()) return allowed;
  if (!std::isfinite(a) || !std::isfinite(b) || !std::isfinite(c)) {
    return Error{ErrorCode::kOutOfRange, std::string(call) + ": every component must be finite"};
  }
  if (!plant_.upright()) {
    return Error{ErrorCode::kUnavailable,
                 std::string(call) + ": the robot has fallen; put it on its feet first"};
  }
  return {};
}

Result<void> SimHumanoid::Move(const hardware::WalkVelocity& v) {
  const auto allowed = MayWalk("Move", v.forward_m_s, v.left_m_s, v.turn_rad_s);
  if (allowed.ok()) plant_.Move(v);
  return allowed;
}

Result<void> SimHumanoid::MoveTo(const hardware::Pose2& target) {
  const auto allowed = MayWalk("MoveTo", target.x_m, target.y_m, target.heading_rad);
  if (allowed.ok()) plant_.MoveTo(target);
  return allowed;
}

Result<void> SimHumanoid::Stop() {
  const auto allowed = Require("Stop", false);
  if (allowed.ok()) plant_.Stop();
  return allowed;
}

hardware::HumanoidProperties SimHumanoid::properties() const {
  return {plant_.joints(), plant_.max_velocity(), plant_.max_stop_time()};
}

}  // namespace horopter::sim
