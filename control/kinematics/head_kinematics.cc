// SPDX-License-Identifier: Apache-2.0
#include "control/kinematics/head_kinematics.h"

#include <cmath>
#include <string>

namespace horopter::control {

using hardware::Eye;
using hardware::HeadAngles;
using hardware::HeadGeometry;
using hardware::PanTilt;
using hardware::Pose;

namespace {

/// Pan about z (left), then tilt about y (down).
Eigen::Matrix3d Rotation(const PanTilt& a) {
  return (Eigen::AngleAxisd(a.pan_rad, Eigen::Vector3d::UnitZ()) *
          Eigen::AngleAxisd(a.tilt_rad, Eigen::Vector3d::UnitY()))
      .toRotationMatrix();
}

Pose MakePose(const Eigen::Matrix3d& R, const Eigen::Vector3d& p) {
  Pose X = Pose::Identity();
  X.linear() = R;
  X.translation() = p;
  return X;
}

}  // namespace

std::vector<hardware::FieldError> Validate(const HeadGeometry& g) {
  std::vector<hardware::FieldError> errors;
  const auto length = [&errors](const char* field, double value) {
    if (!std::isfinite(value) || value < 0) {
      errors.push_back({field, std::to_string(value), "must be finite and not negative"});
    }
  };
  length("head.pan_to_tilt_m", g.pan_to_tilt_m);
  length("head.pan_to_tilt_forward_m", g.pan_to_tilt_forward_m);
  length("head.tilt_to_eyes_m", g.tilt_to_eyes_m);
  length("head.axis_to_optical_centre_m", g.axis_to_optical_centre_m);
  if (!std::isfinite(g.baseline_m) || g.baseline_m <= 0) {
    errors.push_back(
        {"head.baseline_m", std::to_string(g.baseline_m), "must be finite and positive"});
  }
  const Eigen::Matrix3d R = g.X_BN.linear();
  const bool rigid = g.X_BN.matrix().allFinite() &&
                     (R * R.transpose() - Eigen::Matrix3d::Identity()).norm() < 1e-6 &&
                     R.determinant() > 0;
  if (!rigid) {
    errors.push_back({"head.X_BN", "not a rotation and a translation",
                      "its rotation must be orthonormal and right-handed"});
  }
  return errors;
}

Pose HeadPose(const HeadGeometry& g, const PanTilt& neck) {
  const Eigen::AngleAxisd pan(neck.pan_rad, Eigen::Vector3d::UnitZ());
  const Eigen::AngleAxisd tilt(neck.tilt_rad, Eigen::Vector3d::UnitY());
  return g.X_BN * pan * Eigen::Translation3d(g.pan_to_tilt_forward_m, 0, g.pan_to_tilt_m) * tilt *
         Eigen::Translation3d(0, 0, g.tilt_to_eyes_m);
}

Pose EyePose(const HeadGeometry& g, const HeadAngles& angles, Eye eye) {
  const double side = eye == Eye::kLeft ? 1 : -1;
  const Eigen::Matrix3d R_HE = Rotation(angles.eye(eye));
  const Eigen::Vector3d p_HAxis(0, side * g.baseline_m / 2, 0);
  const Eigen::Vector3d p_HC = p_HAxis + R_HE.col(0) * g.axis_to_optical_centre_m;
  return HeadPose(g, angles.neck) * MakePose(R_HE * hardware::OpticalToBody(), p_HC);
}

Pose RightEyeInLeft(const HeadGeometry& g, const HeadAngles& angles) {
  return EyePose(g, angles, Eye::kLeft).inverse() * EyePose(g, angles, Eye::kRight);
}

std::optional<FixationPoint> FindFixationPoint(const HeadGeometry& g, const HeadAngles& angles) {
  const Pose X_BCl = EyePose(g, angles, Eye::kLeft);
  const Pose X_BCr = EyePose(g, angles, Eye::kRight);
  const Eigen::Vector3d left = X_BCl.linear().col(2);
  const Eigen::Vector3d right = X_BCr.linear().col(2);
  const Eigen::Vector3d normal = left.cross(right);
  const double sin_angle = normal.norm();
  if (!(sin_angle > 1e-9)) return std::nullopt;

  const Eigen::Vector3d between = X_BCr.translation() - X_BCl.translation();
  const double along_left = between.cross(right).dot(normal) / normal.squaredNorm();
  const double along_right = between.cross(left).dot(normal) / normal.squaredNorm();
  if (along_left <= 0 || along_right <= 0) return std::nullopt;
  const Eigen::Vector3d on_left = X_BCl.translation() + along_left * left;
  const Eigen::Vector3d on_right = X_BCr.translation() + along_right * right;
  return FixationPoint{(on_left + on_right) / 2, (on_right - on_left).norm()};
}

}  // namespace horopter::control
