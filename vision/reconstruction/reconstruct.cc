// SPDX-License-Identifier: Apache-2.0
#include "vision/reconstruction/reconstruct.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/core.hpp>
#include <stdexcept>
#include <string>

namespace horopter::vision {
namespace {

using hardware::CameraModel;
using hardware::Eye;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr float kNanF = std::numeric_limits<float>::quiet_NaN();

Eigen::Vector2d ExactRay(const CameraModel& camera, const Eigen::Vector2d& pixel) {
  const auto direction = camera.Unproject(pixel);
  if (!direction) return {kNan, kNan};
  return {direction->x(), -direction->y()};
}

/// Direction of a ray in frame P, with unit depth along the eye's axis.
Eigen::Vector3d Direction(const PaperEye& eye, const Eigen::Vector2d& n) {
  return eye.right * n.x() + eye.up * n.y() + eye.forward;
}

double DistanceToRay(const Eigen::Vector3d& point, const PaperEye& eye,
                     const Eigen::Vector3d& direction) {
  return (point - eye.centre).cross(direction).norm() / direction.norm();
}

void CheckField(const DisparityField& d, const CameraModel& left) {
  const cv::Size size(left.width(), left.height());
  if (d.dx.size() != size || d.dy.size() != size || d.valid.size() != size) {
    throw std::invalid_argument("disparity field is " + std::to_string(d.dx.cols) + "x" +
                                std::to_string(d.dx.rows) + ", the left camera " +
                                std::to_string(size.width) + "x" + std::to_string(size.height) +
                                ": dx, dy and valid must have the left image's size");
  }
}

}  // namespace

std::vector<hardware::FieldError> ReconstructionConfig::Validate() const {
  if (std::isfinite(min_parallax_rad) && min_parallax_rad > 0 && min_parallax_rad < 1) return {};
  return {{"reconstruction.min_parallax_rad", std::to_string(min_parallax_rad),
           "must be between 0 and 1, both excluded"}};
}

Reconstructor::Rays::Rays(const CameraModel& model) : camera(model) {
  if (!camera.distortion().any()) return;
  table.create(camera.height(), camera.width());
  cv::parallel_for_(cv::Range(0, table.rows), [&](const cv::Range& rows) {
    for (int v = rows.start; v < rows.end; ++v) {
      for (int u = 0; u < table.cols; ++u) {
        const Eigen::Vector2d ray = ExactRay(camera, Eigen::Vector2d(u, v));
        table(v, u) = {ray.x(), ray.y()};
      }
    }
  });
}

Eigen::Vector2d Reconstructor::Rays::At(const Eigen::Vector2d& pixel) const {
  if (!(pixel.allFinite() && camera.Contains(pixel))) return {kNan, kNan};
  if (table.empty()) {
    const hardware::Intrinsics& in = camera.intrinsics();
    return {(pixel.x() - in.cx) / in.fx, -(pixel.y() - in.cy) / in.fy};
  }
  if (table.cols < 2 || table.rows < 2) return ExactRay(camera, pixel);
  if (pixel == pixel.array().round().matrix()) {
    const cv::Vec2d& ray = table(static_cast<int>(pixel.y()), static_cast<int>(pixel.x()));
    return {ray[0], ray[1]};
  }
  const Eigen::Vector2d guess = Interpolated(pixel);
  const auto seen = camera.Project({guess.x(), -guess.y(), 1});
  if (!seen) return {kNan, kNan};
  return Interpolated(pixel + (pixel - *seen));
}

/// Bilinear; the half pixel beyond the outermost centres is extrapolated from the two next to it.
Eigen::Vector2d Reconstructor::Rays::Interpolated(const Eigen::Vector2d& pixel) const {
  const int u = std::clamp(static_cast<int>(std::floor(pixel.x())), 0, table.cols - 2);
  const int v = std::clamp(static_cast<int>(std::floor(pixel.y())), 0, table.rows - 2);
  const double s = pixel.x() - u, t = pixel.y() - v;
  const cv::Vec2d ray = (table(v, u) * (1 - s) + table(v, u + 1) * s) * (1 - t) +
                        (table(v + 1, u) * (1 - s) + table(v + 1, u + 1) * s) * t;
  return {ray[0], ray[1]};
}

Reconstructor::Reconstructor(const hardware::PerEye<CameraModel>& cameras,
                             const ReconstructionConfig& config)
    : config_((hardware::ThrowIfAny(config.Validate()), config)),
      left_(cameras.left),
      right_(cameras.right) {}

PointField Reconstructor::Reconstruct(const DisparityField& disparity,
                                      const hardware::HeadAngles& angles, double baseline_m,
                                      double axis_to_optical_centre_m) const {
  if (!(std::isfinite(baseline_m) && baseline_m > 0)) {
    throw std::invalid_argument("baseline_m = " + std::to_string(baseline_m) +
                                ": must be finite and positive");
  }
  for (const Eye eye : hardware::kBothEyes) {
    const hardware::PanTilt& a = angles.eye(eye);
    if (!std::isfinite(a.pan_rad) || !std::isfinite(a.tilt_rad)) {
      throw std::invalid_argument(std::string(hardware::ToString(eye)) +
                                  " eye's pan or tilt is not finite");
    }
  }
  return Solve(disparity,
               EyeFromAngles(angles.left, Eye::kLeft, baseline_m, axis_to_optical_centre_m),
               EyeFromAngles(angles.right, Eye::kRight, baseline_m, axis_to_optical_centre_m));
}

PointField Reconstructor::Reconstruct(const DisparityField& disparity,
                                      const hardware::PerEye<hardware::Pose>& X_HC) const {
  return Solve(disparity, EyeFromPose(X_HC.left), EyeFromPose(X_HC.right));
}

PointField Reconstructor::Solve(const DisparityField& disparity, const PaperEye& left,
                                const PaperEye& right) const {
  CheckField(disparity, left_.camera);
  const double min_sine = std::sin(config_.min_parallax_rad);
  const Eigen::Matrix3d R_HP = PaperToBody();
  const cv::Size size = disparity.dx.size();
  PointField field{cv::Mat3f(size, cv::Vec3f::all(kNanF)), cv::Mat1f(size, kNanF)};

  const auto solve_pixel = [&](int v, int u) {
    // What each eye sees at the homologous pixels.
    const Eigen::Vector2d pixel(u, v);
    const Eigen::Vector2d n_left = left_.At(pixel);
    const Eigen::Vector2d n_right =
        right_.At(pixel + Eigen::Vector2d(disparity.dx(v, u), disparity.dy(v, u)));
    const Eigen::Vector3d ray_left = Direction(left, n_left);
    const Eigen::Vector3d ray_right = Direction(right, n_right);
    const double sine = ray_left.cross(ray_right).norm() / (ray_left.norm() * ray_right.norm());
    if (!(sine >= min_sine)) return;  // NaN too

    const Eigen::Vector3d F = SolveNormalEquations(MakeEquationTwo(left, n_left, right, n_right));
    const bool in_front =
        left.forward.dot(F - left.centre) > 0 && right.forward.dot(F - right.centre) > 0;
    if (!in_front || !F.allFinite()) return;
    const Eigen::Vector3f p_H = (R_HP * F).cast<float>();
    field.points(v, u) = {p_H.x(), p_H.y(), p_H.z()};
    field.residual_m(v, u) = static_cast<float>(
        std::max(DistanceToRay(F, left, ray_left), DistanceToRay(F, right, ray_right)));
  };

  cv::parallel_for_(cv::Range(0, size.height), [&](const cv::Range& rows) {
    for (int v = rows.start; v < rows.end; ++v) {
      for (int u = 0; u < size.width; ++u) {
        if (disparity.valid(v, u) != 0) solve_pixel(v, u);
      }
    }
  });
  return field;
}

}  // namespace horopter::vision
