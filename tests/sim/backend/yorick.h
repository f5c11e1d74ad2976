// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <filesystem>

#include "hardware/types/head_angles.h"
#include "hardware/types/head_geometry.h"
#include "sim/backend/yorick_simulation.h"

namespace horopter::sim {

/// Limits of the Yorick head, as scenes/yorick/robot.yaml has them.
inline hardware::HeadLimits YorickLimits() {
  constexpr double d = M_PI / 180;
  const hardware::AxisLimits none;
  return {hardware::AxisLimits{-90 * d, 90 * d, 430 * d, 20000 * d},
          hardware::AxisLimits{-40 * d, 40 * d, 540 * d, 20000 * d},
          hardware::AxisLimits{-45 * d, 0, 540 * d, 38000 * d},
          none,
          hardware::AxisLimits{0, 45 * d, 540 * d, 38000 * d},
          none};
}

/// Geometry of its foveal pair.
inline hardware::HeadGeometry YorickFovealGeometry() {
  hardware::HeadGeometry g;
  g.X_BN.translation() << 0, 0, 1.18;
  g.pan_to_tilt_forward_m = 0.04;
  g.tilt_to_eyes_m = 0.03;
  g.baseline_m = 0.325;
  g.axis_to_optical_centre_m = 0.045;
  return g;
}

/// Yorick at a bare table, with small images.
inline YorickSimulationConfig YorickAtTable() {
  YorickSimulationConfig config;
  config.scene =
      std::filesystem::path(HOROPTER_SOURCE_DIR) / "tests" / "sim" / "backend" / "data/table.xml";
  config.tabletop.reset();
  config.peripheral = hardware::CameraModel::FromHorizontalFov(64, 48, 60 * M_PI / 180);
  config.foveal = hardware::CameraModel::FromHorizontalFov(64, 48, 14 * M_PI / 180);
  config.head.limits = YorickLimits();
  config.head.encoder_resolution_rad = 0.005 * M_PI / 180;
  return config;
}

}  // namespace horopter::sim
