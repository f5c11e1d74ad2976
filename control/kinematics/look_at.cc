// SPDX-License-Identifier: Apache-2.0
#include "control/kinematics/look_at.h"

#include <algorithm>
#include <cmath>

#include "control/kinematics/head_kinematics.h"
#include "hardware/types/config_error.h"

namespace horopter::control {

using hardware::AxisLimits;
using hardware::Eye;
using hardware::HeadAngles;
using hardware::HeadAxis;
using hardware::HeadGeometry;
using hardware::HeadLimits;
using hardware::PanTilt;

namespace {

const AxisLimits& Of(const HeadLimits& limits, HeadAxis axis) {
  return limits[static_cast<int>(axis)];
}

/// The target in the plane of the eyes' axes: how far ahead of H, how far to the left.
struct InEyesPlane {
  double ahead_m;
  double left_m;
};

HeadAngles EyesTowards(const HeadGeometry& g, const InEyesPlane& t, Gaze gaze) {
  HeadAngles angles;
  for (const Eye eye : hardware::kBothEyes) {
    const double side = eye == Eye::kLeft ? 1 : -1;
    const double axis_left_m = gaze == Gaze::kConverging ? side * g.baseline_m / 2 : 0;
    angles.eye(eye).pan_rad = std::atan2(t.left_m - axis_left_m, t.ahead_m);
  }
  return angles;
}

/// Whether the eyes can look at the target from outside their own lever arms, converging ones from
/// farther than half their baseline.
bool FarEnough(const HeadGeometry& g, const InEyesPlane& t, Gaze gaze) {
  const double half_m = g.baseline_m / 2;
  const double nearest_m =
      std::min(std::hypot(t.ahead_m, t.left_m - half_m), std::hypot(t.ahead_m, t.left_m + half_m));
  return nearest_m > g.axis_to_optical_centre_m &&
         t.ahead_m > (gaze == Gaze::kConverging ? half_m : 0);
}

}  // namespace

Fixation LookAt(const HeadGeometry& g, const HeadLimits& limits, const Eigen::Vector3d& p_BT,
                const LookAtOptions& options) {
  const PanTilt home;
  if (!p_BT.allFinite()) {
    return RefuseFixation(FixationFault::kNotFinite, home, p_BT, "is not finite");
  }
  const bool eyes_turn =
      Of(limits, HeadAxis::kLeftPan).exists() || Of(limits, HeadAxis::kRightPan).exists();
  const Gaze gaze = eyes_turn ? options.gaze : Gaze::kParallel;

  const Eigen::Vector3d p_NT = g.X_BN.inverse() * p_BT;
  const double straight = std::atan2(p_NT.y(), p_NT.x());
  const AxisLimits& pan_axis = Of(limits, HeadAxis::kNeckPan);
  const double pan =
      std::clamp(options.neck_pan_rad.value_or(straight), pan_axis.min_rad, pan_axis.max_rad);
  // The target as the panned neck has it: ahead of its elevation axis, to the left, above the axis.
  const double r = std::hypot(p_NT.x(), p_NT.y());
  const double x = r * std::cos(straight - pan) - g.pan_to_tilt_forward_m;
  const double y = r * std::sin(straight - pan);
  const double up = p_NT.z() - g.pan_to_tilt_m;
  if (x <= 0) return RefuseFixation(FixationFault::kBehind, home, p_BT, "is behind the neck");

  const double A = std::hypot(x, up);
  const double C = g.tilt_to_eyes_m;
  const InEyesPlane target{A > C ? std::sqrt((A - C) * (A + C)) : 0.0, y};
  if (!FarEnough(g, target, gaze)) {
    return RefuseFixation(FixationFault::kTooClose, home, p_BT,
                          "is closer than the eyes can converge");
  }
  HeadAngles wanted = EyesTowards(g, target, gaze);
  wanted.neck = {pan, std::asin(C / A) - std::atan2(up, x)};
  const Fixation answer = WithinLimits(wanted, limits, HeadAxis::kNeckPan);
  if (answer.reachable() || pan == straight || options.neck_pan_rad) return answer;
  // The eyes' pan does not make up for what the neck's lacks: that is what to say.
  wanted.neck.pan_rad = straight;
  return WithinLimits(wanted, limits, HeadAxis::kNeckPan);
}

HeadGeometry ForPair(const HeadGeometry& head, const PairMount& mount) {
  HeadGeometry pair = head;
  pair.tilt_to_eyes_m += mount.above_m;
  pair.axis_to_optical_centre_m += mount.ahead_m;
  hardware::ThrowIfAny(Validate(pair));
  return pair;
}

}  // namespace horopter::control
