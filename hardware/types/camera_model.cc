// SPDX-License-Identifier: Apache-2.0
#include "hardware/types/camera_model.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <utility>

#include "hardware/types/field_checker.h"

namespace horopter::hardware {
namespace {

/// As a person would write it: "640", "0.5", "nan".
std::string ToText(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

std::vector<FieldError> Validate(const Intrinsics& in, const Distortion& d) {
  FieldChecker check("camera.");
  check.Require(in.width >= 1, "width", in.width, "must be at least 1");
  check.Require(in.height >= 1, "height", in.height, "must be at least 1");
  check.Require(std::isfinite(in.fx) && in.fx > 0, "fx", in.fx, "must be finite and positive");
  check.Require(std::isfinite(in.fy) && in.fy > 0, "fy", in.fy, "must be finite and positive");
  check.Require(std::isfinite(in.cx), "cx", in.cx, "must be finite");
  check.Require(std::isfinite(in.cy), "cy", in.cy, "must be finite");
  check.Require(std::isfinite(d.k1), "k1", d.k1, "must be finite");
  check.Require(std::isfinite(d.k2), "k2", d.k2, "must be finite");
  check.Require(std::isfinite(d.p1), "p1", d.p1, "must be finite");
  check.Require(std::isfinite(d.p2), "p2", d.p2, "must be finite");
  check.Require(std::isfinite(d.k3), "k3", d.k3, "must be finite");
  return check.Take();
}

/// Radial factor of the distortion at undistorted r^2.
double RadialFactor(const Distortion& d, double r2) {
  return 1 + r2 * (d.k1 + r2 * (d.k2 + r2 * d.k3));
}

/// d/dr [r RadialFactor(r^2)].
double RadialSlope(const Distortion& d, double r2) {
  return 1 + r2 * (3 * d.k1 + r2 * (5 * d.k2 + r2 * 7 * d.k3));
}

/// Where the radial slope turns, as a function of s = r^2: the positive roots of its derivative
/// 3 k1 + 10 k2 s + 21 k3 s^2, ascending.
std::vector<double> SlopeExtrema(const Distortion& d) {
  const double a = 21 * d.k3, b = 10 * d.k2, c = 3 * d.k1;
  std::vector<double> roots;
  const auto keep = [&roots](double s) {
    if (std::isfinite(s) && s > 0) roots.push_back(s);
  };
  const double discriminant = b * b - 4 * a * c;
  if (discriminant < 0) return roots;
  const double q = -(b + std::copysign(std::sqrt(discriminant), b)) / 2;  // no cancellation
  keep(q / a);
  keep(c / q);
  std::sort(roots.begin(), roots.end());
  return roots;
}

/// The x in [low, high] where `below(x)` turns from true to false, to 2^-halvings of the interval.
template <typename Predicate>
double Bisect(double low, double high, int halvings, Predicate below) {
  for (int i = 0; i < halvings; ++i) {
    const double middle = low + (high - low) / 2;
    (below(middle) ? low : high) = middle;
  }
  return low;
}

/// Smallest positive r^2 where the radial slope is 0. Beyond it two directions share a pixel and
/// the model means nothing.
double MonotonicRadius2(const Distortion& d) {
  constexpr double kFarthest2 = 1e6;  // tan(89.94 deg)^2: no rectilinear image reaches it
  double low = 0;
  std::vector<double> ends = SlopeExtrema(d);
  ends.push_back(kFarthest2);
  for (const double end : ends) {  // the slope is monotonic from each end to the next
    const double high = std::min(end, kFarthest2);
    if (RadialSlope(d, high) <= 0) {
      return Bisect(low, high, 80, [&d](double r2) { return RadialSlope(d, r2) > 0; });
    }
    low = high;
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
  const bool good_fov = horizontal_fov_rad > 0 && horizontal_fov_rad < M_PI;
  const double f = good_fov && width >= 1 ? width / 2.0 / std::tan(horizontal_fov_rad / 2) : 1;
  const Intrinsics intrinsics{width, height, f, f, (width - 1) / 2.0, (height - 1) / 2.0};
  std::vector<FieldError> errors = Validate(intrinsics, {});
  if (!good_fov) {
    errors.push_back(
        {"camera.horizontal_fov_rad", ToText(horizontal_fov_rad), "must be between 0 and pi"});
  }
  ThrowIfAny(std::move(errors));
  return CameraModel(intrinsics);
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
  const double radial = RadialFactor(d, r2);
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
  const double tolerance = 1e-12 * std::max(1.0, target.norm());
  Eigen::Vector2d n = InvertRadial(target);
  for (int i = 0; i < kMaxIterations; ++i) {
    Eigen::Matrix2d J;
    const Eigen::Vector2d residual = target - Distort(n, &J);
    if (residual.norm() < tolerance) {
      if (n.squaredNorm() > max_radius2_) return std::nullopt;
      return Eigen::Vector3d(n.x(), n.y(), 1);
    }
    Eigen::Vector2d step = J.inverse() * residual;
    if (!step.allFinite()) return std::nullopt;
    // Damped: near the fold of the polynomial a full step may jump past it.
    if (step.norm() > 0.5) step *= 0.5 / step.norm();
    n += step;
  }
  return std::nullopt;
}

Eigen::Vector2d CameraModel::InvertRadial(const Eigen::Vector2d& target) const {
  const double wanted = target.norm();
  if (wanted == 0) return target;
  const auto short_of_target = [this, wanted](double r) {
    return r * RadialFactor(distortion_, r * r) < wanted;
  };
  double farthest = std::sqrt(max_radius2_);
  if (!std::isfinite(farthest)) {
    farthest = wanted;
    while (short_of_target(farthest)) farthest *= 2;
  }
  return target * (Bisect(0.0, farthest, 16, short_of_target) / wanted);
}

}  // namespace horopter::hardware
