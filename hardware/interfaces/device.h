// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hardware/types/result.h"

namespace horopter::hardware {

/// unconfigured -> inactive (reads only) <-> active (reads and commands); any -> fault.
enum class Lifecycle { kUnconfigured, kInactive, kActive, kFault };

inline const char* ToString(Lifecycle s) {
  switch (s) {
    case Lifecycle::kUnconfigured:
      return "unconfigured";
    case Lifecycle::kInactive:
      return "inactive";
    case Lifecycle::kActive:
      return "active";
    case Lifecycle::kFault:
      return "fault";
  }
  return "?";
}

/// What every device has in common.
///
/// Contract:
/// - A new device is unconfigured. Configure() opens it and leaves it inactive; calling it again
///   on a configured device does nothing and succeeds. It is also the only way out of fault.
/// - Activate() is allowed when inactive (or active: does nothing) and refused otherwise.
/// - Deactivate() first brings everything that moves to a stop; it is idempotent, allowed in every
///   state, and leaves fault and unconfigured as they are.
/// - A call that the state forbids returns kNotActive and has no effect on the device.
/// - A lost link is a fault. Nothing but Configure() leaves it, and never into active.
class Device {
 public:
  virtual ~Device() = default;

  virtual Lifecycle lifecycle() const = 0;
  virtual Result<void> Configure() = 0;
  virtual Result<void> Activate() = 0;
  virtual void Deactivate() = 0;
};

}  // namespace horopter::hardware
