// SPDX-License-Identifier: Apache-2.0
#include "sim/nao/leg_ik.h"

#include <algorithm>
#include <cmath>

namespace horopter::sim {

namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using hardware::Eye;
using hardware::Pose;

double Sign(Eye side) { return side == Eye::kLeft ? 1 : -1; }

Matrix3d RotX(double a) { return AngleAxisd(a, Vector3d::UnitX()).toRotationMatrix(); }
Matrix3d RotY(double a) { return AngleAxisd(a, Vector3d::UnitY()).toRotationMatrix(); }

/// The coupled axis lies halfway between pitch and yaw; positive turns the toes inwards.
Matrix3d HipYawPitch(Eye side, double angle) {
  return AngleAxisd(angle, Vector3d(0, 1, -Sign(side)).normalized()).toRotationMatrix();
}

Vector3d Hip(Eye side) { return {0, Sign(side) * NaoLeg::kHipAside_m, -NaoLeg::kHipBelow_m}; }

/// Heading of the solved foot minus the wanted one.
double HeadingError(Eye side, const Pose& X_TF, double hip_yaw_pitch) {
  const Matrix3d got = LegForward(side, SolveLeg(side, X_TF, hip_yaw_pitch)).linear();
  const Vector3d x = (X_TF.linear().transpose() * got).col(0);
  return std::atan2(x.y(), x.x());
}

}  // namespace

Pose LegForward(Eye side, const LegAngles& leg) {
  Pose X = Pose::Identity();
  const Matrix3d R_hip =
      HipYawPitch(side, leg.hip_yaw_pitch) * RotX(leg.hip_roll) * RotY(leg.hip_pitch);
  const Matrix3d R_knee = R_hip * RotY(leg.knee_pitch);
  X.translation() = Hip(side) - R_hip * Vector3d(0, 0, NaoLeg::kThigh_m) -
                    R_knee * Vector3d(0, 0, NaoLeg::kTibia_m);
  X.linear() = R_knee * RotY(leg.ankle_pitch) * RotX(leg.ankle_roll);
  return X;
}

LegAngles SolveLeg(Eye side, const Pose& X_TF, double hip_yaw_pitch) {
  constexpr double a = NaoLeg::kThigh_m;
  constexpr double b = NaoLeg::kTibia_m;
  LegAngles leg;
  leg.hip_yaw_pitch = hip_yaw_pitch;
  const Matrix3d R0 = HipYawPitch(side, hip_yaw_pitch);
  // Roll brings the ankle into the plane in which hip pitch and knee move it.
  const Vector3d ankle = R0.transpose() * (X_TF.translation() - Hip(side));
  leg.hip_roll = std::atan2(ankle.y(), -ankle.z());
  const Vector3d in_plane = RotX(-leg.hip_roll) * ankle;
  // Law of cosines for the knee, then where the ankle's direction leaves the thigh.
  const double reach2 = std::clamp(in_plane.squaredNorm(), (a - b) * (a - b), (a + b) * (a + b));
  leg.knee_pitch = std::acos(std::clamp((reach2 - a * a - b * b) / (2 * a * b), -1.0, 1.0));
  const double direction = std::atan2(-in_plane.x(), -in_plane.z());
  leg.hip_pitch =
      direction - std::atan2(b * std::sin(leg.knee_pitch), a + b * std::cos(leg.knee_pitch));
  // The ankle's joints turn the sole's normal to where it should point.
  const Vector3d normal = (R0 * RotX(leg.hip_roll)).transpose() * X_TF.linear().col(2);
  leg.ankle_roll = std::asin(std::clamp(-normal.y(), -1.0, 1.0));
  leg.ankle_pitch = std::atan2(normal.x(), normal.z()) - leg.hip_pitch - leg.knee_pitch;
  return leg;
}

double SolveHipYawPitch(Eye side, const Pose& X_TF) {
  constexpr double kMin_rad = -1.145, kMax_rad = 0.741, kNudge_rad = 1e-4;
  double angle = 0;
  for (int i = 0; i < 20; ++i) {
    const double error = HeadingError(side, X_TF, angle);
    const double slope = (HeadingError(side, X_TF, angle + kNudge_rad) - error) / kNudge_rad;
    const double next = std::clamp(angle - error / slope, kMin_rad, kMax_rad);
    const double change = std::abs(next - angle);
    angle = next;
    if (change < 1e-9) break;
  }
  return angle;
}

}  // namespace horopter::sim
