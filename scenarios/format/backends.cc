// SPDX-License-Identifier: Apache-2.0
#include "scenarios/format/backends.h"

#include <algorithm>

namespace horopter::scenarios {

const std::vector<BackendInfo>& Backends() {
  static const std::vector<BackendInfo> backends = {
      {"sim", "MuJoCo in lockstep; needs a GL context (OSMesa, EGL) and the scenes folder.", ""},
      {"emulated", "The robot's real drivers on emulated firmware, with MuJoCo as the plant.",
       "this build has neither drivers nor firmware emulators; use --backend sim"},
      {"hardware", "The robot itself, on a serial port or a socket.",
       "this build has no drivers, and no robot's port is configured; use --backend sim"},
      {"replay", "A recording of an earlier run.",
       "this build can neither make nor read recordings; use --backend sim"}};
  return backends;
}

const BackendInfo* FindBackend(std::string_view name) {
  const auto& all = Backends();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const BackendInfo& b) { return b.name == name; });
  return found == all.end() ? nullptr : &*found;
}

std::vector<std::string> BackendNames() {
  std::vector<std::string> names;
  for (const BackendInfo& backend : Backends()) names.push_back(backend.name);
  return names;
}

}  // namespace horopter::scenarios
