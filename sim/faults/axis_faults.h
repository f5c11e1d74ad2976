// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "hardware/types/head_angles.h"
#include "hardware/types/time.h"
#include "sim/faults/fault.h"
#include "sim/random/random_stream.h"

namespace horopter::sim {

/// What the faults of one axis do between its motor, its eye and its encoder.
///
/// The motor follows the commands, and the encoder reads the motor. The eye (the load) stands where
/// play and a wrong zero leave it.
class AxisFaults {
 public:
  /// Takes those of `faults` that concern `axis`. @pre Validate(faults) is empty
  AxisFaults(const std::vector<Fault>& faults, hardware::HeadAxis axis, std::uint64_t seed);

  /// No fault concerns this axis, ever.
  bool none() const {
    return plays_.empty() && constants_.empty() && noises_.empty() && stuck_.empty();
  }

  /// Whether the motor is held now.
  bool Stuck(hardware::Time t) const;

  /// Where the eye is driven, and how fast.
  struct Load {
    double position_rad = 0;
    double speed_rad_s = 0;
  };
  /// Follows the motor. To be called for every step of the motor, in order.
  Load Follow(double motor_rad, double motor_speed_rad_s, hardware::Time t);

  /// What the encoder would read without rounding, with the eye at `eye_rad` and the motor where
  /// Follow() last saw it. Draws new noise at every call, also when no fault is active.
  double Read(double eye_rad, hardware::Time t);

 private:
  struct Play {
    TimeWindow when;
    double half_width_rad;
    double lag_rad = 0;  ///< the load's place less the motor's
  };
  /// Added to the load, and to the readings.
  struct Constant {
    TimeWindow when;
    double load_rad;
    double reading_rad;
  };
  struct Noise {
    TimeWindow when;
    double std_rad;
    RandomStream random;
  };

  std::vector<Play> plays_;
  std::vector<Constant> constants_;
  std::vector<Noise> noises_;
  std::vector<TimeWindow> stuck_;
  std::optional<double> motor_rad_;  ///< at the last Follow()
  double load_offset_rad_ = 0;       ///< the load's place less the motor's, all faults together
};

}  // namespace horopter::sim
