// SPDX-License-Identifier: Apache-2.0
#include "sim/backend/pose_history.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace horopter::sim {

using hardware::Eye;
using hardware::Time;

PoseHistory::PoseHistory(World& world, const hardware::PerEye<std::string>& mjcf_camera)
    : world_(world), mjcf_camera_(mjcf_camera) {
  for (const Eye eye : hardware::kBothEyes) world.Id(mjOBJ_CAMERA, mjcf_camera[eye]);
}

void PoseHistory::Record(Time t, bool keep_world) {
  turns_.push_back({t,
                    {world_.X_WCamera(mjcf_camera_.left).linear(),
                     world_.X_WCamera(mjcf_camera_.right).linear()}});
  if (!keep_world) return;
  WorldPoses poses;
  if (!spare_.empty()) {
    poses = std::move(spare_.back());
    spare_.pop_back();
  }
  poses.Save(world_);
  states_.push_back({t, std::move(poses)});
}

void PoseHistory::ForgetBefore(Time t) {
  while (turns_.size() > 1 && turns_[1].t <= t) turns_.pop_front();
  while (states_.size() > 1 && states_[1].t <= t) {
    spare_.push_back(std::move(states_.front().poses));
    states_.pop_front();
  }
}

WorldPoses& PoseHistory::WorldOf(Time t) {
  assert(!states_.empty());
  auto after = std::upper_bound(states_.begin(), states_.end(), t,
                                [](Time value, const State& s) { return value < s.t; });
  return after == states_.begin() ? after->poses : (after - 1)->poses;
}

Eigen::Matrix3d PoseHistory::RotationAt(Eye eye, Time t) const {
  const auto at = std::lower_bound(turns_.begin(), turns_.end(), t,
                                   [](const Turn& turn, Time value) { return turn.t < value; });
  return at == turns_.end() ? turns_.back().R_WC[eye] : at->R_WC[eye];
}

EyeMotion PoseHistory::Motion(Eye eye, Time middle, hardware::Duration half) const {
  EyeMotion motion;
  if (half.count() == 0) return motion;
  const Eigen::Matrix3d R_MW = RotationAt(eye, middle).transpose();
  for (std::size_t i = 0; i < turns_.size(); ++i) {
    const bool ends_before = i + 1 < turns_.size() && turns_[i + 1].t <= middle - half;
    const bool begins_after = i > 0 && turns_[i - 1].t >= middle + half;
    if (ends_before || begins_after) continue;
    motion.Add(hardware::ToSeconds(turns_[i].t - middle), R_MW * turns_[i].R_WC[eye]);
  }
  return motion;
}

}  // namespace horopter::sim
