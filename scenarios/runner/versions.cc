// SPDX-License-Identifier: Apache-2.0
#include "scenarios/runner/versions.h"

#include <LinearMath/btScalar.h>
#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <opencv2/core/utility.hpp>
#include <span>

#include "scenarios/results/files.h"
#include "scenarios/results/hasher.h"
#include "scenarios/results/results_error.h"
#include "scenarios/runner/build_version.h"

namespace horopter::scenarios {
namespace {

std::string ProgramHash() {
  try {
    const std::string program = ReadFile("/proc/self/exe");
    Hasher hasher;
    hasher.Update(std::as_bytes(std::span(program)));
    constexpr std::size_t kDigits = 12;
    return hasher.Hex().substr(0, kDigits);
  } catch (const ResultsError&) {
    return "unknown";
  }
}

std::map<std::string, std::string> FindVersions() {
  return {{"horopter", Version()},
          {"program", ProgramHash()},
          {"mujoco", mj_versionString()},
          {"opencv", cv::getVersionString()},
          {"eigen",
           fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
          {"bullet", fmt::format("{}.{}", BT_BULLET_VERSION / 100, BT_BULLET_VERSION % 100)},
          {"compiler", __VERSION__}};
}

}  // namespace

std::string Version() { return fmt::format("{} ({})", HOROPTER_VERSION, HOROPTER_COMMIT); }

std::map<std::string, std::string> LibraryVersions() {
  static const std::map<std::string, std::string> versions = FindVersions();
  return versions;
}

}  // namespace horopter::scenarios
