// SPDX-License-Identifier: Apache-2.0
#include "control/kinematics/fixate.h"

#include <algorithm>
#include <cmath>

#include "control/kinematics/head_kinematics.h"
#include "control/kinematics/look_at.h"

namespace horopter::control {

using hardware::AxisLimits;
using hardware::Eye;
using hardware::HeadAngles;
using hardware::HeadAxis;
using hardware::HeadGeometry;
using hardware::HeadLimits;
using hardware::PanTilt;

namespace {

/// Pan and tilt that point body axes' x at p.
PanTilt Towards(const Eigen::Vector3d& p) {
  return {std::atan2(p.y(), p.x()), std::atan2(-p.z(), std::hypot(p.x(), p.y()))};
}

const AxisLimits& Of(const HeadLimits& limits, HeadAxis axis) {
  return limits[static_cast<int>(axis)];
}

}  // namespace

Fixation FixateWithEyes(const HeadGeometry& g, const HeadLimits& limits, const PanTilt& neck,
                        const Eigen::Vector3d& p_BT) {
  if (!p_BT.allFinite())
    return RefuseFixation(FixationFault::kNotFinite, neck, p_BT, "is not finite");
  const Eigen::Vector3d p_HT = HeadPose(g, neck).inverse() * p_BT;
  if (p_HT.x() <= 0)
    return RefuseFixation(FixationFault::kBehind, neck, p_BT, "is behind the eyes");

  HeadAngles wanted;
  wanted.neck = neck;
  double nearest = p_HT.norm() - g.baseline_m / 2;
  for (const Eye eye : hardware::kBothEyes) {
    const double side = eye == Eye::kLeft ? 1 : -1;
    const Eigen::Vector3d from_axis = p_HT - Eigen::Vector3d(0, side * g.baseline_m / 2, 0);
    wanted.eye(eye) = Towards(from_axis);
    nearest = std::min(nearest, from_axis.norm() - g.axis_to_optical_centre_m);
  }
  if (nearest <= 0) {
    return RefuseFixation(FixationFault::kTooClose, neck, p_BT,
                          "is closer than the eyes can converge");
  }
  return WithinLimits(wanted, limits, HeadAxis::kLeftPan);
}

Fixation FixateWithNeck(const HeadGeometry& g, const HeadLimits& limits,
                        const Eigen::Vector3d& p_BT) {
  const bool behind = (g.X_BN.inverse() * p_BT).x() <= 0;
  if (behind) return RefuseFixation(FixationFault::kBehind, {}, p_BT, "is behind the neck");
  return LookAt(g, limits, p_BT);
}

Fixation Fixate(const HeadGeometry& g, const HeadLimits& limits, const PanTilt& neck,
                const Eigen::Vector3d& p_BT) {
  const bool eyes_tilt =
      Of(limits, HeadAxis::kLeftTilt).exists() && Of(limits, HeadAxis::kRightTilt).exists();
  return eyes_tilt ? FixateWithEyes(g, limits, neck, p_BT) : FixateWithNeck(g, limits, p_BT);
}

}  // namespace horopter::control
