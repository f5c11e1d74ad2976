// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hardware/interfaces/device.h"
#include "hardware/types/base_state.h"

namespace horopter::hardware {

/// A base with two driven sides.
///
/// Contract (besides Device's):
/// - Read() is allowed when inactive or active. Encoder counts are unwrapped and zero at the first
///   Configure(); times do not decrease.
/// - Command() sets both wheel speeds and returns at once. Speeds beyond the base's maximum are
///   scaled down together, so that the path's curvature is kept. A speed that is not finite is
///   refused with kOutOfRange; anything is refused with kNotActive unless active.
/// - Deadman: a base that has had no command for the period its backend states stops by itself.
class MobileBase : public Device {
 public:
  virtual Result<BaseState> Read() = 0;
  virtual Result<void> Command(const WheelSpeeds& speeds) = 0;
  virtual BaseProperties properties() const = 0;
};

}  // namespace horopter::hardware
