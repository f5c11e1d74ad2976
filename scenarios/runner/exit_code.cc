// SPDX-License-Identifier: Apache-2.0
#include "scenarios/runner/exit_code.h"

#include "hardware/types/config_error.h"
#include "scenarios/format/diagnostics.h"
#include "scenarios/runner/backend.h"
#include "scenarios/runner/session.h"
#include "sim/world/world.h"

namespace horopter::scenarios {

ExitCode ExitCodeOf(const std::exception& error) {
  const auto is = [&error]<typename T>(T*) { return dynamic_cast<const T*>(&error) != nullptr; };
  if (is(static_cast<BackendUnavailable*>(nullptr)) || is(static_cast<DeviceFailure*>(nullptr))) {
    return ExitCode::kHardwareUnavailable;
  }
  if (is(static_cast<ScenarioError*>(nullptr)) || is(static_cast<sim::SceneError*>(nullptr)) ||
      is(static_cast<hardware::ConfigError*>(nullptr))) {
    return ExitCode::kBadInput;
  }
  return ExitCode::kInfrastructure;
}

}  // namespace horopter::scenarios
