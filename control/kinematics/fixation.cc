// SPDX-License-Identifier: Apache-2.0
#include "control/kinematics/fixation.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace horopter::control {

using hardware::AxisLimits;
using hardware::HeadAxis;

Fixation RefuseFixation(FixationFault fault, const hardware::PanTilt& neck,
                        const Eigen::Vector3d& p_BT, const std::string& because) {
  char point[96];
  std::snprintf(point, sizeof point, "(%.3f, %.3f, %.3f) m", p_BT.x(), p_BT.y(), p_BT.z());
  Fixation fixation;
  fixation.angles.neck = neck;
  fixation.fault = fault;
  fixation.why = std::string("target ") + point + " in the base frame " + because;
  return fixation;
}

Fixation WithinLimits(const hardware::HeadAngles& wanted, const hardware::HeadLimits& limits,
                      HeadAxis first_axis) {
  constexpr double kRounding = 1e-12;
  constexpr double kDegrees = 180 / M_PI;
  Fixation fixation;
  hardware::HeadAxisArray angles = hardware::ToArray(wanted);
  for (int i = static_cast<int>(first_axis); i < hardware::kHeadAxisCount; ++i) {
    const AxisLimits& axis = limits[i];
    const double clamped = std::clamp(angles[i], axis.min_rad, axis.max_rad);
    if (std::abs(clamped - angles[i]) > kRounding && fixation.reachable()) {
      char text[160];
      std::snprintf(
          text, sizeof text, "%.*s would have to be %.2f deg; its limits are %.2f to %.2f",
          static_cast<int>(hardware::kHeadAxisNames[i].size()), hardware::kHeadAxisNames[i].data(),
          angles[i] * kDegrees, axis.min_rad * kDegrees, axis.max_rad * kDegrees);
      fixation.fault = FixationFault::kBeyondLimits;
      fixation.axis = static_cast<HeadAxis>(i);
      fixation.why = text;
    }
    angles[i] = clamped;
  }
  fixation.angles = hardware::FromArray(angles);
  return fixation;
}

}  // namespace horopter::control
