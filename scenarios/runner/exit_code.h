// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <exception>

namespace horopter::scenarios {

/// Exit codes of `horopter`, in rising order of how much they say is wrong.
enum class ExitCode {
  kPassed = 0,
  kExpectationFailed = 1,
  kBadInput = 2,        ///< or usage
  kInfrastructure = 3,  ///< no GL, disk full, physics that blew up, a fault of our own
  kHardwareUnavailable = 4,
};

/// What an exception that ended a run means for the exit code.
ExitCode ExitCodeOf(const std::exception& error);

}  // namespace horopter::scenarios
