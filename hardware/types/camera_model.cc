// SPDX-License-Identifier: Apache-2.0
#include "hardware/types/camera_model.h"

#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <string>

namespace horopter::hardware {
namespace {

std::vector<FieldError> Validate(const Intrinsics& in, const Distortion& d) {
  std::vector<FieldError> errors;
  const auto require = [&errors](bool good, const char* field, double value, const char* rule) {
    if (!good) errors.push_back({field, std::to_string(value), rule});
  };
  require(in.width >= 1, "camera.width", in.width, "must be at least 1");
  require(in.height >= 1, "camera.height", in.height, "must be at least 1");
  require(std::isfinite(in.fx) && in.fx > 0, "camera.fx", in.fx, "must be finite and positive");
  require(std::isfinite(in.fy) && in.fy > 0, "camera.fy", in.fy, "must be finite and positive");
  require(std::isfinite(in.cx), "camera.cx", in.cx, "must be finite");
  require(std::isfinite(in.cy), "camera.cy", in.cy, "must be finite");
  require(std::isfinite(d.k1), "camera.k1", d.k1, "must be finite");
  require(std::isfinite(d.k2), "camera.k2", d.k2, "must be finite");
  require(std::isfinite(d.p1), "camera.p1", d.p1, "must be finite");
  require(std::isfinite(d.p2), "camera.p2", d.p2, "must be finite");
  require(std::isfinite(d.k3), "camera.k3", d.k3, "must be finite");
  return errors;
}

/// Smallest positive r^2 where d/dr [r (1 + k1 r^2 + k2 r^4 + k3 r^6)] = 0. Beyond it two
/// directions share a pixel and the model means nothing.
double MonotonicRadius2(const Distortion& d) {
  const auto slope = [&d](double r2) {
    return 1 + r2 * (3 * d.k1 + r2 * (5 * d.k2 + r2 * 7 * d.k3));
  };
  constexpr double kFarthest2 = 100.0;  // tan(84 deg)^2: wider than any rectilinear lens
  constexpr int kSteps = 4000;
  for (int i = 1; i <= kSteps; ++i) {
    if (slope(kFarthest2 * i / kSteps) > 0) continue;
    double low = kFarthest2 * (i - 1) / kSteps;
    double high = kFarthest2 * i / kSteps;
    for (int k = 0; k < 60; ++k) {
      const double middle = (low + high) / 2;
      (slope(middle) > 0 ? low : high) = middle;
    }
    return low;
  }
  return std::numeric_limits<double>::infinity();
}

}  // namespace

CameraModel::CameraModel(const Intrinsics& intrinsics, const Distortion& distortion)
    : intrinsics_(intrinsics), distortion_(distortion) {
  ThrowIfAny(Validate(intrinsics, distortion));
  max_radius2_ = MonotonicRadius2(distortion);
}

CameraModel CameraModel::FromHorizontalFov(int width, int height, double horizontal_fov_rad) {
  if (!(horizontal_fov_rad > 0 && horizontal_fov_rad < M_PI)) {
    throw ConfigError({{"camera.horizontal_fov_rad", std::to_string(horizontal_fov_rad),
                        "must be between 0 and pi"}});
  }
  const double f = width / 2.0 / std::tan(horizontal_fov_rad / 2);
  return CameraModel({width, height, f, f, (width - 1) / 2.0, (height - 1) / 2.0});
}

double CameraModel::horizontal_fov_rad() const {
  return std::atan((intrinsics_.cx + 0.5) / intrinsics_.fx) +
         std::atan((intrinsics_.width - 0.5 - intrinsics_.cx) / intrinsics_.fx);
}

double CameraModel::vertical_fov_rad() const {
  return std::atan((intrinsics_.cy + 0.5) / intrinsics_.fy) +
         std::atan((intrinsics_.height - 0.5 - intrinsics_.cy) / intrinsics_.fy);
}

Eigen::Vector2d CameraModel::Distort(const Eigen::Vector2d& n, Eigen::Matrix2d* jacobian) const {
  const Distortion& d = distortion_;
  const double x = n.x(), y = n.y();
  const double r2 = x * x + y * y;
  const double radial = 1 + r2 * (d.k1 + r2 * (d.k2 + r2 * d.k3));
  if (jacobian != nullptr) {
    const double slope = 2 * (d.k1 + r2 * (2 * d.k2 + r2 * 3 * d.k3));  // d radial / d r2, times 2
    (*jacobian)(0, 0) = radial + x * x * slope + 2 * d.p1 * y + 6 * d.p2 * x;
    (*jacobian)(0, 1) = x * y * slope + 2 * d.p1 * x + 2 * d.p2 * y;
    (*jacobian)(1, 0) = (*jacobian)(0, 1);
    (*jacobian)(1, 1) = radial + y * y * slope + 6 * d.p1 * y + 2 * d.p2 * x;
  }
  return {x * radial + 2 * d.p1 * x * y + d.p2 * (r2 + 2 * x * x),
          y * radial + d.p1 * (r2 + 2 * y * y) + 2 * d.p2 * x * y};
}

std::optional<Eigen::Vector2d> CameraModel::Project(const Eigen::Vector3d& p_C) const {
  if (!p_C.allFinite() || p_C.z() <= 0) return std::nullopt;
  const Eigen::Vector2d n = p_C.head<2>() / p_C.z();
  if (!n.allFinite() || n.squaredNorm() > max_radius2_) return std::nullopt;
  const Eigen::Vector2d m = distortion_.any() ? Distort(n, nullptr) : n;
  return Eigen::Vector2d(intrinsics_.fx * m.x() + intrinsics_.cx,
                         intrinsics_.fy * m.y() + intrinsics_.cy);
}

std::optional<Eigen::Vector3d> CameraModel::Unproject(const Eigen::Vector2d& pixel) const {
  if (!pixel.allFinite()) return std::nullopt;
  const Eigen::Vector2d target((pixel.x() - intrinsics_.cx) / intrinsics_.fx,
                               (pixel.y() - intrinsics_.cy) / intrinsics_.fy);
  if (!distortion_.any()) return Eigen::Vector3d(target.x(), target.y(), 1);

  constexpr int kMaxIterations = 50;
  constexpr double kTolerance = 1e-12;
  Eigen::Vector2d n = target;
  for (int i = 0; i < kMaxIterations; ++i) {
    Eigen::Matrix2d J;
    const Eigen::Vector2d residual = target - Distort(n, &J);
    if (residual.norm() < kTolerance) {
      if (n.squaredNorm() > max_radius2_) return std::nullopt;
      return Eigen::Vector3d(n.x(), n.y(), 1);
    }
    Eigen::Vector2d step = J.inverse() * residual;
    if (!step.allFinite()) return std::nullopt;
    // Damped: a full step may jump past the fold of the polynomial.
    if (step.norm() > 0.5) step *= 0.5 / step.norm();
    n += step;
  }
  return std::nullopt;
}

}  // namespace horopter::hardware
