// SPDX-License-Identifier: Apache-2.0
#include "scenarios/render/state_log.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace horopter::scenarios {
namespace {

constexpr double kDegrees = 180 / M_PI;

/// Without the sign of what rounds to nothing.
double Rounded(double value, double steps) { return std::round(value * steps) / steps + 0.0; }

hardware::Pose BaseOf(const sim::WorldState& state) {
  const auto base = std::find_if(state.bodies.begin(), state.bodies.end(),
                                 [](const sim::BodyPose& b) { return b.body == "base"; });
  return base == state.bodies.end() ? hardware::Pose::Identity() : base->X_WB;
}

/// Yaw about z, then pitch about the new y, then roll about the new x [deg].
Eigen::Vector3d YawPitchRollDeg(const Eigen::Matrix3d& R) {
  return Eigen::Vector3d(std::atan2(R(1, 0), R(0, 0)), std::asin(std::clamp(-R(2, 0), -1.0, 1.0)),
                         std::atan2(R(2, 1), R(2, 2))) *
         kDegrees;
}

}  // namespace

HeadMotion HeadIn(const sim::WorldState& state) {
  hardware::HeadAxisArray angles{};
  HeadMotion head;
  for (const sim::JointReading& joint : state.joints) {
    const auto& names = hardware::kHeadAxisNames;
    const auto axis = std::find(names.begin(), names.end(), joint.joint);
    if (axis == names.end()) continue;
    const auto i = static_cast<std::size_t>(axis - names.begin());
    angles[i] = joint.position;
    head.speed_rad_s[i] = joint.velocity;
  }
  head.angles = hardware::FromArray(angles);
  return head;
}

std::string StateLog::Header() {
  std::string header = "t_s,base_x_m,base_y_m,base_z_m,base_yaw_deg,base_pitch_deg,base_roll_deg";
  for (const std::string_view axis : hardware::kHeadAxisNames) {
    header += fmt::format(",{0}_deg,{0}_deg_s", axis);
  }
  return header;
}

void StateLog::Record(hardware::Time t, const sim::World& world) {
  const sim::WorldState& state =
      states_.emplace_hint(states_.end(), t, sim::ReadWorldState(world))->second;
  const hardware::Pose X_OB = X_OW_ * BaseOf(state);
  const Eigen::Vector3d turn = YawPitchRollDeg(X_OB.linear());
  if (!rows_.empty()) rows_ += "\n";
  rows_ += fmt::format("{:.9f}", hardware::ToSeconds(t));
  for (const double value : {X_OB.translation().x(), X_OB.translation().y(), X_OB.translation().z(),
                             turn.x(), turn.y(), turn.z()}) {
    rows_ += fmt::format(",{:.7f}", Rounded(value, 1e7));
  }
  const HeadMotion head = HeadIn(state);
  const hardware::HeadAxisArray angles = hardware::ToArray(head.angles);
  for (std::size_t i = 0; i < angles.size(); ++i) {
    rows_ += fmt::format(",{:.6f},{:.4f}", Rounded(angles[i] * kDegrees, 1e6),
                         Rounded(head.speed_rad_s[i] * kDegrees, 1e4));
  }
}

const sim::WorldState& StateLog::At(hardware::Time t) const {
  const auto after = states_.upper_bound(t);
  return after == states_.begin() ? after->second : std::prev(after)->second;
}

void StateLog::ForgetBefore(hardware::Time t) {
  const auto after = states_.upper_bound(t);
  if (after != states_.begin()) states_.erase(states_.begin(), std::prev(after));
}

std::string StateLog::TakeRows() { return std::exchange(rows_, {}); }

}  // namespace horopter::scenarios
