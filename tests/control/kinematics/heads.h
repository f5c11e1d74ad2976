// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "hardware/types/head_angles.h"
#include "hardware/types/head_geometry.h"

namespace horopter::control {

inline hardware::HeadGeometry KoalaHead() {
  hardware::HeadGeometry g;
  g.X_BN.translation() << 0.05, 0.0, 0.30;
  g.baseline_m = 0.08;
  return g;
}

inline hardware::HeadLimits KoalaLimits() {
  const hardware::AxisLimits none;
  const hardware::AxisLimits pan{-1.2, 1.2, 3, 30};
  const hardware::AxisLimits tilt{-0.8, 0.8, 3, 30};
  return {none, none, pan, tilt, pan, tilt};
}

inline hardware::HeadGeometry YorickHead() {
  hardware::HeadGeometry g;
  g.X_BN.translation() << 0.10, 0.02, 0.80;
  g.pan_to_tilt_m = 0.06;
  g.tilt_to_eyes_m = 0.04;
  g.baseline_m = 0.325;
  g.axis_to_optical_centre_m = 0.03;
  return g;
}

inline hardware::HeadLimits YorickLimits() {
  const double d = M_PI / 180;
  const hardware::AxisLimits none;
  const hardware::AxisLimits pan{-90 * d, 90 * d, 8, 80};
  const hardware::AxisLimits elevation{-40 * d, 40 * d, 8, 80};
  // Left turns right (negative), right turns left (positive).
  return {pan, elevation, {-45 * d, 0, 8, 600}, none, {0, 45 * d, 8, 600}, none};
}

}  // namespace horopter::control
