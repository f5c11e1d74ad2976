// SPDX-License-Identifier: Apache-2.0
#include "sim/backend/sim_head.h"

#include <cmath>

namespace horopter::sim {

using hardware::Error;
using hardware::ErrorCode;
using hardware::Result;

Result<hardware::HeadReading> SimHead::Read() {
  if (const auto allowed = Require("Read", true); !allowed.ok()) return allowed.error();
  return hardware::HeadReading{clock_.Now(), head_.ReadEncoders()};
}

Result<void> SimHead::Command(const hardware::HeadAngles& target) {
  if (const auto allowed = Require("Command", false); !allowed.ok()) return allowed;
  for (const double angle : hardware::ToArray(target)) {
    if (!std::isfinite(angle)) {
      return Error{ErrorCode::kOutOfRange, "head command: every angle must be finite"};
    }
  }
  head_.Command(target);
  return {};
}

}  // namespace horopter::sim
