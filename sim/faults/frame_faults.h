// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "hardware/types/eye.h"
#include "hardware/types/time.h"
#include "sim/faults/fault.h"

namespace horopter::sim {

/// The faults that lie between the light and a frame's arrival, which a camera model has to know
/// of: dark eyes and lost frames. Pure functions of the frame, whatever was asked before.
class FrameFaults {
 public:
  FrameFaults() = default;
  /// @pre Validate(faults) is empty
  FrameFaults(const std::vector<Fault>& faults, std::uint64_t seed);

  /// Share of the light that an eye gets at `t`.
  double Light(hardware::Eye eye, hardware::Time t) const;

  /// Whether an eye's frame of this number, taken at `t`, is lost. Number 0 never is. Which numbers
  /// are lost does not depend on when the fault is there.
  bool Loses(hardware::Eye eye, std::uint64_t frame, hardware::Time t) const;

 private:
  struct Loss {
    LostFrames what;
    TimeWindow when;
    std::uint64_t stream;
  };
  struct Darkness {
    DarkEye what;
    TimeWindow when;
  };
  std::vector<Loss> losses_;
  std::vector<Darkness> darkness_;
};

}  // namespace horopter::sim
