// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "hardware/types/base_state.h"
#include "hardware/types/pose.h"
#include "hardware/types/time.h"

namespace horopter::control {

/// Where the base is by its wheels: encoder counts integrated as a unicycle, one exact arc between
/// two readings. Frame O is the base where odometry began.
class Odometry {
 public:
  /// @param history how far back PoseAt() reaches
  /// @throws hardware::ConfigError when a property is not positive
  explicit Odometry(const hardware::BaseProperties& base,
                    hardware::Duration history = std::chrono::seconds(5));

  /// Takes a reading; the first one only sets the reference. A reading no newer than the last is
  /// ignored. @return X_OB
  const hardware::Pose2& Update(const hardware::BaseState& state);

  const hardware::Pose2& pose() const { return pose_; }

  /// X_OB at a past instant, along the arc between the readings around it; the newest pose for a
  /// later instant. @return nothing before the first reading or the history's reach
  std::optional<hardware::Pose2> PoseAt(hardware::Time t) const;

  double travelled_m() const { return travelled_m_; }  ///< length of the path so far

 private:
  struct Entry {
    hardware::Time t{};
    hardware::Pose2 pose;
    double forward_m = 0;  ///< of the arc that led here from the entry before
    double turn_rad = 0;
  };

  hardware::BaseProperties base_;
  hardware::Duration history_length_;
  hardware::Pose2 pose_;
  std::optional<hardware::BaseState> last_;
  std::deque<Entry> history_;
  double travelled_m_ = 0;
};

}  // namespace horopter::control
