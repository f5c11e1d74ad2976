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
  places_.push_back(
      {t, {world_.X_WCamera(mjcf_camera_.left), world_.X_WCamera(mjcf_camera_.right)}});
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
  while (places_.size() > 1 && places_[1].t <= t) places_.pop_front();
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

hardware::Pose PoseHistory::PoseAt(Eye eye, Time t) const {
  const auto at = std::lower_bound(places_.begin(), places_.end(), t,
                                   [](const Place& place, Time value) { return place.t < value; });
  return at == places_.end() ? places_.back().X_WC[eye] : at->X_WC[eye];
}

EyeMotion PoseHistory::Motion(Eye eye, Time middle, hardware::Duration half) const {
  EyeMotion motion;
  if (half.count() == 0) return motion;
  const hardware::Pose X_MW = PoseAt(eye, middle).inverse();
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const bool ends_before = i + 1 < places_.size() && places_[i + 1].t <= middle - half;
    const bool begins_after = i > 0 && places_[i - 1].t >= middle + half;
    if (ends_before || begins_after) continue;
    const hardware::Pose X_MC = X_MW * places_[i].X_WC[eye];
    motion.Add(hardware::ToSeconds(places_[i].t - middle), X_MC.linear(), X_MC.translation());
  }
  return motion;
}

}  // namespace horopter::sim
