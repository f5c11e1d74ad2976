// SPDX-License-Identifier: Apache-2.0
#include "scenarios/runner/versions.h"

#include <LinearMath/btScalar.h>
#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <opencv2/core/utility.hpp>

namespace horopter::scenarios {

std::map<std::string, std::string> LibraryVersions() {
  return {{"horopter", HOROPTER_VERSION},
          {"mujoco", mj_versionString()},
          {"opencv", cv::getVersionString()},
          {"eigen",
           fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
          {"bullet", fmt::format("{}.{}", BT_BULLET_VERSION / 100, BT_BULLET_VERSION % 100)},
          {"compiler", __VERSION__}};
}

}  // namespace horopter::scenarios
