// SPDX-License-Identifier: Apache-2.0
#include "scenarios/runner/exit_code.h"

#include "hardware/types/config_error.h"
#include "scenarios/format/diagnostics.h"
#include "scenarios/results/results_error.h"
#include "scenarios/runner/backend.h"
#include "scenarios/runner/session.h"
#include "sim/world/world.h"

namespace horopter::scenarios {
namespace {

template <typename... Types>
bool IsOneOf(const std::exception& error) {
  return ((dynamic_cast<const Types*>(&error) != nullptr) || ...);
}

/// A device that is gone or does not answer is not there; one that refuses a call was called
/// wrongly, which is our own fault.
ExitCode CodeOf(hardware::ErrorCode code) {
  switch (code) {
    case hardware::ErrorCode::kTimeout:
    case hardware::ErrorCode::kDisconnected:
    case hardware::ErrorCode::kProtocol:
    case hardware::ErrorCode::kUnavailable:
      return ExitCode::kHardwareUnavailable;
    case hardware::ErrorCode::kNotActive:
    case hardware::ErrorCode::kOutOfRange:
      break;
  }
  return ExitCode::kInfrastructure;
}

}  // namespace

ExitCode ExitCodeOf(const std::exception& error) {
  if (const auto* failure = dynamic_cast<const DeviceFailure*>(&error)) {
    return CodeOf(failure->code());
  }
  if (IsOneOf<BackendUnavailable>(error)) return ExitCode::kHardwareUnavailable;
  if (IsOneOf<ScenarioError, sim::SceneError, hardware::ConfigError, UnusableResults>(error)) {
    return ExitCode::kBadInput;
  }
  return ExitCode::kInfrastructure;
}

}  // namespace horopter::scenarios
