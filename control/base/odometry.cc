// SPDX-License-Identifier: Apache-2.0
#include "control/base/odometry.h"

#include <algorithm>
#include <cmath>

#include "control/base/unicycle.h"

namespace horopter::control {

using hardware::Pose2;
using hardware::Time;

Odometry::Odometry(const hardware::BaseProperties& base, hardware::Duration history)
    : base_((hardware::ThrowIfAny(Validate(base)), base)), history_length_(history) {}

const Pose2& Odometry::Update(const hardware::BaseState& state) {
  if (last_ && state.t <= last_->t) return pose_;
  Entry entry{state.t, pose_, 0, 0};
  if (last_) {
    const double left =
        static_cast<double>(state.left_pulses - last_->left_pulses) * base_.metres_per_pulse;
    const double right =
        static_cast<double>(state.right_pulses - last_->right_pulses) * base_.metres_per_pulse;
    entry.forward_m = (left + right) / 2;
    entry.turn_rad = (right - left) / base_.effective_track_m;
    pose_ = AlongArc(pose_, entry.forward_m, entry.turn_rad);
    entry.pose = pose_;
    travelled_m_ += std::abs(entry.forward_m);
  }
  last_ = state;
  history_.push_back(entry);
  while (history_.size() > 1 && history_[1].t + history_length_ <= state.t) history_.pop_front();
  return pose_;
}

std::optional<Pose2> Odometry::PoseAt(Time t) const {
  if (history_.empty() || t < history_.front().t) return std::nullopt;
  if (t >= history_.back().t) return pose_;
  const auto after = std::upper_bound(history_.begin(), history_.end(), t,
                                      [](Time value, const Entry& e) { return value < e.t; });
  const auto before = std::prev(after);
  const double part =
      hardware::ToSeconds(t - before->t) / hardware::ToSeconds(after->t - before->t);
  return AlongArc(before->pose, part * after->forward_m, part * after->turn_rad);
}

}  // namespace horopter::control
