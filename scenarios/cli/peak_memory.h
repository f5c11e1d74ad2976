// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

namespace horopter::scenarios {

/// The most memory that this process has held so far (VmHWM) [MB, 10^6 bytes]; nothing where the
/// system does not tell.
std::optional<double> PeakMemoryMb();

}  // namespace horopter::scenarios
