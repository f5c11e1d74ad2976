// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <filesystem>

#include "sim/backend/koala_simulation.h"

namespace horopter::sim {

inline constexpr double kDegree = M_PI / 180;

/// A Koala as scenes/koala/robot.yaml describes it, on open ground, with small images.
inline KoalaSimulationConfig KoalaInYard() {
  KoalaSimulationConfig config;
  config.scene =
      std::filesystem::path(HOROPTER_SOURCE_DIR) / "tests" / "sim" / "backend" / "data/yard.xml";
  config.camera = hardware::CameraModel::FromHorizontalFov(64, 48, 60 * kDegree);
  const hardware::AxisLimits pan{-158.9 * kDegree, 158.9 * kDegree, 120 * kDegree, 600 * kDegree};
  const hardware::AxisLimits tilt{-31.0 * kDegree, 46.6 * kDegree, 120 * kDegree, 600 * kDegree};
  config.head.limits = {hardware::AxisLimits{}, hardware::AxisLimits{}, pan, tilt, pan, tilt};
  config.head.encoder_resolution_rad = 0.0514285 * kDegree;
  config.base = {0.045e-3, 0.310, 0.5715};
  return config;
}

}  // namespace horopter::sim
