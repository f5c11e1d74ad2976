// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenarios/results/run_record.h"

namespace horopter::scenarios {

/// This machine, and how busy it is now. What the system does not tell is left unknown.
Machine ThisMachine();

}  // namespace horopter::scenarios
