// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

namespace horopter::scenarios {

/// One way to render, and whether it works here.
struct GlDiagnosis {
  std::string backend;
  std::string renderer;  ///< GL_RENDERER; "" when it does not work
  std::string problem;   ///< why not; "" when it works
};

struct BackendDiagnosis {
  std::string name;
  std::string doc;
  std::string problem;  ///< what is missing; "" when it can be used
};

/// What this machine and this build can do.
struct Diagnosis {
  std::map<std::string, std::string> versions;  ///< library, version
  std::string processor;                        ///< "" when unknown
  unsigned cores = 0;
  std::vector<std::string> cpu_features;  ///< of those that kernels choose by
  std::vector<GlDiagnosis> gl;
  std::string scenes_dir;
  std::vector<std::string> robots;
  std::vector<std::string> scenes;
  std::vector<BackendDiagnosis> backends;
  std::vector<std::string> warnings;  ///< settings of the environment that are known to harm

  /// True when the backend of that name can be used.
  bool Usable(const std::string& backend) const;
};

/// Looks: creates a GL context of each kind, reads the scenes folder and the environment.
Diagnosis Diagnose();

}  // namespace horopter::scenarios
