// SPDX-License-Identifier: Apache-2.0
#include "scenarios/render/head_reach.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "control/kinematics/gaze_angles.h"
#include "hardware/types/config_error.h"
#include "sim/nao/head_limits.h"

namespace horopter::scenarios {
namespace {

constexpr double kRadians = M_PI / 180;
/// Angles in degrees come back from radians with their last bits changed.
constexpr double kRounding_deg = 1e-9;

}  // namespace

HeadReach::HeadReach(const RobotDescription& robot)
    : robot_(robot.name), limits_(robot.head_limits), is_nao_(robot.name == "nao") {}

Interval HeadReach::NeckTiltAt(double pan_deg) const {
  const auto& tilt = limits_[static_cast<std::size_t>(hardware::HeadAxis::kNeckTilt)];
  Interval range{tilt.min_rad / kRadians, tilt.max_rad / kRadians};
  if (!is_nao_) return range;
  const sim::PitchRange pitch = sim::NaoPitchRange(pan_deg * kRadians);
  return {std::max(range.low, pitch.min_rad / kRadians),
          std::min(range.high, pitch.max_rad / kRadians)};
}

hardware::HeadAngles HeadReach::AnglesOf(const Gaze& gaze, const std::string& where) const {
  const control::Fixation turned = control::Turn(
      {{gaze.pan_deg * kRadians, gaze.tilt_deg * kRadians}, gaze.vergence_deg * kRadians}, limits_);
  if (!turned.reachable()) {
    throw hardware::ConfigError({{where + "gaze",
                                  fmt::format("pan {:g}, tilt {:g}, vergence {:g} deg",
                                              gaze.pan_deg, gaze.tilt_deg, gaze.vergence_deg),
                                  "is beyond this head: " + turned.why}});
  }
  RequireNeckTilt(turned.angles, where);
  return turned.angles;
}

void HeadReach::Require(const hardware::HeadAngles& angles, const std::string& where) const {
  const hardware::HeadAxisArray array = hardware::ToArray(angles);
  for (std::size_t axis = 0; axis < array.size(); ++axis) {
    const double deg = array[axis] / kRadians;
    const double low = limits_[axis].min_rad / kRadians, high = limits_[axis].max_rad / kRadians;
    if (deg >= low - kRounding_deg && deg <= high + kRounding_deg) continue;
    const std::string name = where + std::string(hardware::kHeadAxisNames[axis]) + "_deg";
    throw hardware::ConfigError(
        {{name, fmt::format("{:g}", deg),
          limits_[axis].exists() ? fmt::format("must be from {:.1f} to {:.1f}", low, high)
                                 : "robot '" + robot_ + "' has no such axis"}});
  }
  RequireNeckTilt(angles, where);
}

void HeadReach::RequireNeckTilt(const hardware::HeadAngles& angles,
                                const std::string& where) const {
  const double pan_deg = angles.neck.pan_rad / kRadians;
  const double tilt_deg = angles.neck.tilt_rad / kRadians;
  const Interval range = NeckTiltAt(pan_deg);
  if (tilt_deg >= range.low - kRounding_deg && tilt_deg <= range.high + kRounding_deg) return;
  throw hardware::ConfigError(
      {{where + "tilt", fmt::format("{:g} deg", tilt_deg),
        fmt::format("at a pan of {:g} deg this head tilts from {:.1f} to {:.1f} deg", pan_deg,
                    range.low, range.high)}});
}

}  // namespace horopter::scenarios
