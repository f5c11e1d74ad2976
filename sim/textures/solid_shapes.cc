// SPDX-License-Identifier: Apache-2.0
#include "sim/textures/solid_shapes.h"

#include <algorithm>
#include <cmath>

namespace horopter::sim {

cv::Vec3d UnitBoxPoint(const Surface& s, double x_m, double y_m) {
  const double right = 2 * x_m / s.width_m - 1;
  const double up = 1 - 2 * y_m / s.height_m;
  switch (s.side) {
    case Side::kBack:
      return {-1, -right, up};
    case Side::kLeft:
      return {-right, 1, up};
    case Side::kRight:
      return {right, -1, up};
    case Side::kTop:
      return {right, up, 1};
    case Side::kBottom:
      return {right, -up, -1};
    case Side::kFlat:
    case Side::kFront:
      break;
  }
  return {1, right, up};
}

CylinderPoint OnCylinder(const Surface& s, double x_m, double y_m) {
  if (s.side == Side::kFlat) {
    return {(2 * x_m / s.width_m - 1) * M_PI, y_m / s.height_m, 1};
  }
  const cv::Vec3d p = UnitBoxPoint(s, x_m, y_m);
  const double across = std::hypot(p[0], p[1]);
  const double angle = std::atan2(p[1], p[0]);
  const double steepness = std::abs(p[2]) / std::max(across, 1e-12);
  if (steepness <= 1) return {angle, (1 - p[2] / across) / 2, 1};
  return {angle, p[2] > 0 ? 0.0 : 1.0, 1 / steepness};
}

CylinderSize SizeOfCylinder(const Surface& s) {
  switch (s.side) {
    case Side::kFlat:
      return {s.width_m / (2 * M_PI), s.height_m};
    case Side::kTop:
    case Side::kBottom:
      return {s.width_m / 2, s.depth_m};
    default:
      return {s.width_m / 2, s.height_m};
  }
}

}  // namespace horopter::sim
