// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scenarios/format/fault_spec.h"
#include "sim/faults/fault.h"

namespace horopter::scenarios {

/// A scenario's faults as the simulation has them: radians, axes and eyes as such.
/// @throws hardware::ConfigError naming an axis or eye that does not exist
std::vector<sim::Fault> FaultsOf(const std::vector<FaultSpec>& specs);

}  // namespace horopter::scenarios
