// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>
#include <cmath>

namespace horopter::hardware {

/// Rigid transform in monogram notation: X_WB maps p_BQ to p_WQ = X_WB * p_BQ. Metres.
using Pose = Eigen::Isometry3d;

/// Pose on the ground plane: x forward at heading 0, y to the left, heading counter-clockwise.
struct Pose2 {
  double x_m = 0;
  double y_m = 0;
  double heading_rad = 0;
};

/// Velocity of a unicycle in its own frame: forward, and turning left.
struct Twist2 {
  double forward_m_s = 0;
  double turn_rad_s = 0;
};

/// Wraps an angle to (-pi, pi].
inline double WrapAngle(double rad) {
  const double wrapped = std::remainder(rad, 2 * M_PI);
  return wrapped <= -M_PI ? wrapped + 2 * M_PI : wrapped;
}

/// Lifts a planar pose to 3D at height z.
inline Pose ToPose(const Pose2& p, double z_m = 0) {
  Pose X = Pose::Identity();
  X.translation() << p.x_m, p.y_m, z_m;
  X.linear() = Eigen::AngleAxisd(p.heading_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  return X;
}

/// What is left of a pose on the ground plane: its place, and the heading of its x axis.
inline Pose2 ToPose2(const Pose& X) {
  return {X.translation().x(), X.translation().y(), std::atan2(X(1, 0), X(0, 0))};
}

/// Rotation that maps optical axes (x right, y down, z forward) into body axes (x forward, y left,
/// z up): p_body = OpticalToBody() * p_optical.
inline Eigen::Matrix3d OpticalToBody() {
  Eigen::Matrix3d R;
  R << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  return R;
}

}  // namespace horopter::hardware
