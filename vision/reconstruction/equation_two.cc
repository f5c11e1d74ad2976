// SPDX-License-Identifier: Apache-2.0
#include "vision/reconstruction/equation_two.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

namespace horopter::vision {

Eigen::Matrix3d PaperToBody() {
  Eigen::Matrix3d R;
  R << 0, 0, -1, -1, 0, 0, 0, 1, 0;
  return R;
}

PaperEye EyeFromAngles(const hardware::PanTilt& angles, hardware::Eye eye, double baseline_m,
                       double axis_to_optical_centre_m) {
  const double alpha = -angles.pan_rad;
  const double beta = angles.tilt_rad;
  const double sa = std::sin(alpha), ca = std::cos(alpha);
  const double sb = std::sin(beta), cb = std::cos(beta);
  const double side = eye == hardware::Eye::kLeft ? -1 : 1;
  const Eigen::Vector3d forward(sa * cb, -sb, -ca * cb);
  const Eigen::Vector3d axis(side * baseline_m / 2, 0, 0);
  return {{ca, 0, sa}, {sa * sb, cb, -ca * sb}, forward, axis + axis_to_optical_centre_m * forward};
}

PaperEye EyeFromPose(const hardware::Pose& X_HC) {
  const Eigen::Matrix3d R_PC = PaperToBody().transpose() * X_HC.linear();
  return {R_PC.col(0), -R_PC.col(1), R_PC.col(2), PaperToBody().transpose() * X_HC.translation()};
}

EquationTwo MakeEquationTwo(const PaperEye& left_eye, const Eigen::Vector2d& left,
                            const PaperEye& right_eye, const Eigen::Vector2d& right) {
  EquationTwo system;
  system.A.row(0) = left.x() * left_eye.forward - left_eye.right;
  system.A.row(1) = left.y() * left_eye.forward - left_eye.up;
  system.A.row(2) = right.x() * right_eye.forward - right_eye.right;
  system.A.row(3) = right.y() * right_eye.forward - right_eye.up;
  system.b.head<2>() = system.A.topRows<2>() * left_eye.centre;
  system.b.tail<2>() = system.A.bottomRows<2>() * right_eye.centre;
  return system;
}

Eigen::Vector3d SolveNormalEquations(const EquationTwo& system) {
  const Eigen::Matrix3d N = system.A.transpose() * system.A;
  return N.inverse() * (system.A.transpose() * system.b);
}

}  // namespace horopter::vision
