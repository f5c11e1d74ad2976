// SPDX-License-Identifier: Apache-2.0
#include "scenarios/runner/exit_code.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "hardware/types/config_error.h"
#include "scenarios/results/results_error.h"
#include "scenarios/runner/backend.h"
#include "scenarios/runner/session.h"
#include "sim/world/world.h"

namespace horopter::scenarios {
namespace {

using hardware::ErrorCode;

TEST(ExitCodeOf, DevicesThatAreNotThereAreUnavailableAndMisusedOnesOurFault) {
  const auto code = [](ErrorCode e) { return ExitCodeOf(DeviceFailure("reading", {e, "why"})); };
  for (const ErrorCode e : {ErrorCode::kTimeout, ErrorCode::kDisconnected, ErrorCode::kProtocol,
                            ErrorCode::kUnavailable}) {
    EXPECT_EQ(code(e), ExitCode::kHardwareUnavailable);
  }
  for (const ErrorCode e : {ErrorCode::kNotActive, ErrorCode::kOutOfRange}) {
    EXPECT_EQ(code(e), ExitCode::kInfrastructure);
  }
  EXPECT_STREQ(DeviceFailure("reading the base", {ErrorCode::kTimeout, "no answer"}).what(),
               "reading the base: no answer");
}

TEST(ExitCodeOf, WhatAPersonNamedIsBadInputAndTheRestIsNot) {
  EXPECT_EQ(ExitCodeOf(sim::SceneError("room.xml: no such body")), ExitCode::kBadInput);
  EXPECT_EQ(ExitCodeOf(hardware::ConfigError({{"rate_hz", "0", "must be positive"}})),
            ExitCode::kBadInput);
  EXPECT_EQ(ExitCodeOf(UnusableResults("no such folder")), ExitCode::kBadInput);
  EXPECT_EQ(ExitCodeOf(BackendUnavailable("no serial port")), ExitCode::kHardwareUnavailable);
  EXPECT_EQ(ExitCodeOf(ResultsError("disk full")), ExitCode::kInfrastructure);
  EXPECT_EQ(ExitCodeOf(std::invalid_argument("a size of ours")), ExitCode::kInfrastructure);
}

}  // namespace
}  // namespace horopter::scenarios
