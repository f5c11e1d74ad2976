// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "hardware/types/camera_model.h"
#include "hardware/types/eye.h"
#include "hardware/types/head_angles.h"
#include "hardware/types/pose.h"

namespace horopter::vision {

/// Optical frame of an eye in the head, from rotations about body axes: independent of the paper's
/// equations.
inline hardware::Pose EyeInHead(const hardware::PanTilt& a, hardware::Eye eye, double baseline_m) {
  hardware::Pose X = hardware::Pose::Identity();
  X.linear() = Eigen::AngleAxisd(a.pan_rad, Eigen::Vector3d::UnitZ()) *
               Eigen::AngleAxisd(a.tilt_rad, Eigen::Vector3d::UnitY()) * hardware::OpticalToBody();
  X.translation().y() = (eye == hardware::Eye::kLeft ? 1 : -1) * baseline_m / 2;
  return X;
}

/// Where an eye sees a point of the head frame; nothing when it is not in the image.
inline std::optional<Eigen::Vector2d> See(const hardware::CameraModel& camera,
                                          const hardware::Pose& X_HC, const Eigen::Vector3d& p_H) {
  const auto pixel = camera.Project(X_HC.inverse() * p_H);
  if (!pixel || !camera.Contains(*pixel)) return std::nullopt;
  return pixel;
}

}  // namespace horopter::vision
