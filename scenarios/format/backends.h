// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace horopter::scenarios {

/// A way to give a scenario a robot.
struct BackendInfo {
  std::string name;
  std::string doc;      ///< one sentence
  std::string missing;  ///< what this build lacks to use it, and the remedy; "" when it can
};

/// Every backend that a scenario or a command line may name.
const std::vector<BackendInfo>& Backends();

/// The backend of that name, or nullptr.
const BackendInfo* FindBackend(std::string_view name);

std::vector<std::string> BackendNames();

}  // namespace horopter::scenarios
