// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "hardware/types/eye.h"
#include "hardware/types/pose.h"
#include "hardware/types/time.h"
#include "sim/backend/world_poses.h"
#include "sim/camera/eye_motion.h"
#include "sim/world/world.h"

namespace horopter::sim {

/// What a pair of cameras must remember to show the past: where each was at every physics step,
/// and the whole world at the instants that were asked for.
///
/// Before its first entry the world is taken to have rested.
class PoseHistory {
 public:
  /// @param mjcf_camera names of the cameras; @throws SceneError when the world lacks one
  PoseHistory(World& world, const hardware::PerEye<std::string>& mjcf_camera);

  /// Records the cameras' poses at `t`, and the world's poses where `keep_world`.
  /// @pre t later than all before
  void Record(hardware::Time t, bool keep_world);

  /// Forgets what is older than `t`, but for the last state before it.
  void ForgetBefore(hardware::Time t);

  /// The world as it was kept at `t`, or at the last kept instant before. @pre one was recorded
  WorldPoses& WorldOf(hardware::Time t);

  /// How an eye turned and moved from `middle - half` to `middle + half`, with a sample beyond
  /// either end.
  EyeMotion Motion(hardware::Eye eye, hardware::Time middle, hardware::Duration half) const;

 private:
  struct Place {
    hardware::Time t;
    hardware::PerEye<hardware::Pose> X_WC;
  };
  struct State {
    hardware::Time t;
    WorldPoses poses;
  };
  hardware::Pose PoseAt(hardware::Eye eye, hardware::Time t) const;

  World& world_;
  hardware::PerEye<std::string> mjcf_camera_;
  std::deque<Place> places_;
  std::deque<State> states_;
  std::vector<WorldPoses> spare_;  ///< of forgotten states, to use their memory again
};

}  // namespace horopter::sim
