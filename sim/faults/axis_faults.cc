// SPDX-License-Identifier: Apache-2.0
#include "sim/faults/axis_faults.h"

#include <algorithm>

namespace horopter::sim {
namespace {

using hardware::HeadAxis;

HeadAxis PanOf(hardware::Eye eye) {
  return eye == hardware::Eye::kLeft ? HeadAxis::kLeftPan : HeadAxis::kRightPan;
}
HeadAxis TiltOf(hardware::Eye eye) {
  return eye == hardware::Eye::kLeft ? HeadAxis::kLeftTilt : HeadAxis::kRightTilt;
}

}  // namespace

AxisFaults::AxisFaults(const std::vector<Fault>& faults, HeadAxis axis, std::uint64_t seed) {
  for (std::size_t i = 0; i < faults.size(); ++i) {
    const auto& [kind, when] = faults[i];
    if (const auto* play = std::get_if<Backlash>(&kind); play && play->axis == axis) {
      plays_.push_back({when, play->width_rad / 2});
    } else if (const auto* bias = std::get_if<EncoderBias>(&kind); bias && bias->axis == axis) {
      constants_.push_back({when, 0, bias->bias_rad});
    } else if (const auto* noise = std::get_if<EncoderNoise>(&kind); noise && noise->axis == axis) {
      noises_.push_back({when, noise->std_rad, RandomStream(seed, StreamName(faults, i))});
    } else if (const auto* stuck = std::get_if<StuckAxis>(&kind); stuck && stuck->axis == axis) {
      stuck_.push_back(when);
    } else if (const auto* zero = std::get_if<ZeroOff>(&kind)) {
      const double off_rad = PanOf(zero->eye) == axis    ? zero->pan_rad
                             : TiltOf(zero->eye) == axis ? zero->tilt_rad
                                                         : 0;
      if (off_rad != 0) constants_.push_back({when, off_rad, 0});
    }
  }
}

bool AxisFaults::Stuck(hardware::Time t) const {
  return std::any_of(stuck_.begin(), stuck_.end(),
                     [t](const TimeWindow& when) { return when.Contains(t); });
}

AxisFaults::Load AxisFaults::Follow(double motor_rad, double motor_speed_rad_s, hardware::Time t) {
  const double moved = motor_rad - motor_rad_.value_or(motor_rad);
  motor_rad_ = motor_rad;
  load_offset_rad_ = 0;
  double speed_rad_s = motor_speed_rad_s;
  for (Play& play : plays_) {
    if (!play.when.Contains(t)) {
      play.lag_rad = 0;
      continue;
    }
    // The load stays until the motor has crossed the play and takes it along.
    const double staying = play.lag_rad - moved;
    play.lag_rad = std::clamp(staying, -play.half_width_rad, play.half_width_rad);
    load_offset_rad_ += play.lag_rad;
    if (play.lag_rad == staying) speed_rad_s = 0;
  }
  for (const Constant& constant : constants_) {
    if (constant.when.Contains(t)) load_offset_rad_ += constant.load_rad;
  }
  return {motor_rad + load_offset_rad_, speed_rad_s};
}

double AxisFaults::Read(double eye_rad, hardware::Time t) {
  double reading = eye_rad - load_offset_rad_;
  for (const Constant& constant : constants_) {
    if (constant.when.Contains(t)) reading += constant.reading_rad;
  }
  for (Noise& noise : noises_) {
    const double drawn = noise.std_rad * noise.random.Gaussian();
    if (noise.when.Contains(t)) reading += drawn;
  }
  return reading;
}

}  // namespace horopter::sim
