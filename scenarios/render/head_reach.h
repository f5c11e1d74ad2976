// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "hardware/types/head_angles.h"
#include "scenarios/format/robot_description.h"

namespace horopter::scenarios {

/// Where a head looks, as people write it: pan positive left, tilt positive down, vergence the
/// angle between the optical axes.
struct Gaze {
  double pan_deg = 0;
  double tilt_deg = 0;
  double vergence_deg = 0;
};

/// From one value to another; both alike: that value.
struct Interval {
  double low = 0;
  double high = 0;
};

/// How far a head turns: each axis by the robot's limits, and the NAO's pitch as far as its
/// shoulders allow at that yaw.
class HeadReach {
 public:
  explicit HeadReach(const RobotDescription& robot);

  const hardware::HeadLimits& limits() const { return limits_; }

  /// Range of the neck's tilt at a pan of the neck [deg].
  Interval NeckTiltAt(double pan_deg) const;

  /// The axes' angles for a gaze.
  /// @param where heads the message, e.g. "gazes.csv:3: "
  /// @throws hardware::ConfigError naming the gaze, and the range there is, when the head cannot
  ///         turn so far
  hardware::HeadAngles AnglesOf(const Gaze& gaze, const std::string& where = "") const;

  /// @throws hardware::ConfigError naming the first axis that cannot turn so far, or that the head
  ///         lacks and that is not 0
  void Require(const hardware::HeadAngles& angles, const std::string& where = "") const;

 private:
  void RequireNeckTilt(const hardware::HeadAngles& angles, const std::string& where) const;

  std::string robot_;
  hardware::HeadLimits limits_;
  bool is_nao_;
};

}  // namespace horopter::scenarios
