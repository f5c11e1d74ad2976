// SPDX-License-Identifier: Apache-2.0
#include "control/kinematics/fixate.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "control/kinematics/head_kinematics.h"

namespace horopter::control {

using hardware::AxisLimits;
using hardware::Eye;
using hardware::HeadAngles;
using hardware::HeadAxis;
using hardware::HeadAxisArray;
using hardware::HeadGeometry;
using hardware::HeadLimits;
using hardware::PanTilt;

namespace {

std::string Text(const Eigen::Vector3d& p) {
  char text[96];
  std::snprintf(text, sizeof text, "(%.3f, %.3f, %.3f) m", p.x(), p.y(), p.z());
  return text;
}

Fixation Refuse(FixationFault fault, const PanTilt& neck, const Eigen::Vector3d& p_BT,
                const std::string& because) {
  Fixation fixation;
  fixation.angles.neck = neck;
  fixation.fault = fault;
  fixation.why = "target " + Text(p_BT) + " in the base frame " + because;
  return fixation;
}

/// Clamps every axis of `wanted` to its limits and says which was the first beyond them.
/// @param first_axis axes before it keep their angle (a neck that this head does not move)
Fixation WithinLimits(const HeadAngles& wanted, const HeadLimits& limits, HeadAxis first_axis) {
  constexpr double kRounding = 1e-12;
  constexpr double kDegrees = 180 / M_PI;
  Fixation fixation;
  HeadAxisArray angles = hardware::ToArray(wanted);
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
  if (!p_BT.allFinite()) return Refuse(FixationFault::kNotFinite, neck, p_BT, "is not finite");
  const Eigen::Vector3d p_HT = HeadPose(g, neck).inverse() * p_BT;
  if (p_HT.x() <= 0) return Refuse(FixationFault::kBehind, neck, p_BT, "is behind the eyes");

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
    return Refuse(FixationFault::kTooClose, neck, p_BT, "is closer than the eyes can converge");
  }
  return WithinLimits(wanted, limits, HeadAxis::kLeftPan);
}

Fixation FixateWithNeck(const HeadGeometry& g, const HeadLimits& limits,
                        const Eigen::Vector3d& p_BT) {
  const PanTilt home;
  if (!p_BT.allFinite()) return Refuse(FixationFault::kNotFinite, home, p_BT, "is not finite");
  const Eigen::Vector3d p_NT = g.X_BN.inverse() * p_BT;
  if (p_NT.x() <= 0) return Refuse(FixationFault::kBehind, home, p_BT, "is behind the neck");

  const double r = std::hypot(p_NT.x(), p_NT.y());
  const double above_tilt_axis = p_NT.z() - g.pan_to_tilt_m;
  const double A = std::hypot(r, above_tilt_axis);
  // Distance from H to the target once the eyes' plane passes through it.
  const double forward =
      A > g.tilt_to_eyes_m ? std::sqrt((A - g.tilt_to_eyes_m) * (A + g.tilt_to_eyes_m)) : 0.0;
  if (forward <= g.baseline_m / 2 ||
      std::hypot(forward, g.baseline_m / 2) <= g.axis_to_optical_centre_m) {
    return Refuse(FixationFault::kTooClose, home, p_BT, "is closer than the eyes can converge");
  }

  HeadAngles wanted;
  wanted.neck.pan_rad = std::atan2(p_NT.y(), p_NT.x());
  wanted.neck.tilt_rad = -(std::atan2(above_tilt_axis, r) - std::asin(g.tilt_to_eyes_m / A));
  const bool has_vergence =
      Of(limits, HeadAxis::kLeftPan).exists() || Of(limits, HeadAxis::kRightPan).exists();
  if (has_vergence) {
    wanted.right.pan_rad = std::atan2(g.baseline_m / 2, forward);
    wanted.left.pan_rad = -wanted.right.pan_rad;
  }
  return WithinLimits(wanted, limits, HeadAxis::kNeckPan);
}

Fixation Fixate(const HeadGeometry& g, const HeadLimits& limits, const PanTilt& neck,
                const Eigen::Vector3d& p_BT) {
  const bool eyes_tilt =
      Of(limits, HeadAxis::kLeftTilt).exists() && Of(limits, HeadAxis::kRightTilt).exists();
  return eyes_tilt ? FixateWithEyes(g, limits, neck, p_BT) : FixateWithNeck(g, limits, p_BT);
}

}  // namespace horopter::control
