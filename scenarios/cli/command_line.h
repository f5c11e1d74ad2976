// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace horopter::scenarios {

/// The program `horopter`: reads the command line, does what it says, and returns the exit code
/// (scenarios/runner/exit_code.h). Never throws; every error is one line on standard error.
int RunCommandLine(int argc, const char* const* argv);

}  // namespace horopter::scenarios
