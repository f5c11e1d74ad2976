// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/epipolar_prior.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/core.hpp>
#include <optional>
#include <stdexcept>
#include <tuple>

#include "hardware/types/field_checker.h"

namespace horopter::vision {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;

constexpr int kGridPx = 8;

hardware::Pose Moved(const hardware::Pose& X_ClCr, const Vector6& by) {
  hardware::Pose step = hardware::Pose::Identity();
  const double angle = by.head<3>().norm();
  if (angle > 0) step.linear() = Eigen::AngleAxisd(angle, by.head<3>() / angle).toRotationMatrix();
  step.translation() = by.tail<3>();
  return step * X_ClCr;
}

/// Where the right eye sees what lies along a direction at an inverse depth.
std::optional<Eigen::Vector2d> SeenRight(const hardware::CameraModel& right,
                                         const hardware::Pose& X_ClCr,
                                         const Eigen::Vector3d& direction_Cl,
                                         double inverse_depth) {
  // Scaled by the inverse depth, so that infinity is a point like any other.
  const hardware::Pose X_CrCl = X_ClCr.inverse();
  return right.Project(X_CrCl.linear() * direction_Cl + inverse_depth * X_CrCl.translation());
}

void RequireCovariance(const Eigen::Matrix<double, 6, 6>& covariance) {
  const bool symmetric = covariance.allFinite() && covariance.isApprox(covariance.transpose());
  const bool zero = covariance.isZero();
  if (!zero && (!symmetric || covariance.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff() <
                                  -1e-12 * covariance.trace())) {
    throw std::invalid_argument(
        "epipolar prior: the pose's covariance must be symmetric and not negative");
  }
}

}  // namespace

std::vector<hardware::FieldError> EpipolarPriorConfig::Validate() const {
  hardware::FieldChecker check("epipolar_prior.");
  check.Require(std::isfinite(min_depth_m) && min_depth_m > 0, "min_depth_m", min_depth_m,
                "must be positive");
  check.NotNegative("sigmas", sigmas);
  check.NotNegative("slack_px", slack_px);
  return check.Take();
}

EpipolarPrior::EpipolarPrior(const hardware::CameraModel& left, const hardware::CameraModel& right,
                             const RelativePose& pose, const EpipolarPriorConfig& config)
    : config_((hardware::ThrowIfAny(config.Validate()), config)),
      size_(left.width(), left.height()) {
  RequireCovariance(pose.covariance);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  bounds_ = {kInfinity, -kInfinity, kInfinity, -kInfinity};
  // One more than needed, so that every pixel lies between four.
  columns_ = (left.width() - 1) / kGridPx + 2;
  rows_ = (left.height() - 1) / kGridPx + 2;
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      lines_.push_back(LineOf(left, right, pose, {column * kGridPx, row * kGridPx}));
      if (lines_.back().known) Extend(lines_.back());
    }
  }
}

EpipolarPrior::Line EpipolarPrior::LineOf(const hardware::CameraModel& left,
                                          const hardware::CameraModel& right,
                                          const RelativePose& pose,
                                          const Eigen::Vector2d& pixel) const {
  Line line;
  const auto direction = left.Unproject(pixel);
  if (!direction) return line;
  const double nearest = 1 / config_.min_depth_m;
  const auto far = SeenRight(right, pose.X_ClCr, *direction, 0);
  const auto near = SeenRight(right, pose.X_ClCr, *direction, nearest);
  if (!far || !near) return line;
  line.far = *far - pixel;
  line.near = *near - pixel;

  // First-order deviation of the line's middle, by central differences over the six parameters.
  constexpr double kStep = 1e-4;
  Eigen::Matrix<double, 2, 6> jacobian;
  for (int i = 0; i < 6; ++i) {
    const Vector6 by = kStep * Vector6::Unit(i);
    const auto plus = SeenRight(right, Moved(pose.X_ClCr, by), *direction, nearest / 4);
    const auto minus = SeenRight(right, Moved(pose.X_ClCr, -by), *direction, nearest / 4);
    if (!plus || !minus) return line;
    jacobian.col(i) = (*plus - *minus) / (2 * kStep);
  }
  const Eigen::Matrix2d spread = jacobian * pose.covariance * jacobian.transpose();
  line.sigma_px = std::sqrt(std::max(0.0, spread.trace()));
  line.known = true;
  return line;
}

void EpipolarPrior::Extend(const Line& line) {
  const double more = config_.sigmas * line.sigma_px + config_.slack_px;
  for (const Eigen::Vector2d& end : {line.far, line.near}) {
    bounds_.low_x = std::min(bounds_.low_x, end.x() - more);
    bounds_.high_x = std::max(bounds_.high_x, end.x() + more);
    bounds_.low_y = std::min(bounds_.low_y, end.y() - more);
    bounds_.high_y = std::max(bounds_.high_y, end.y() + more);
  }
}

bool EpipolarPrior::Allows(int x, int y, float dx, float dy) const {
  const int column = x / kGridPx, row = y / kGridPx;
  const double ax = static_cast<double>(x - column * kGridPx) / kGridPx;
  const double ay = static_cast<double>(y - row * kGridPx) / kGridPx;
  Eigen::Vector2d far(0, 0), near(0, 0);
  double sigma_px = 0;
  for (const auto& [down, across, weight] :
       {std::tuple(0, 0, (1 - ax) * (1 - ay)), std::tuple(0, 1, ax * (1 - ay)),
        std::tuple(1, 0, (1 - ax) * ay), std::tuple(1, 1, ax * ay)}) {
    const Line& line = lines_[static_cast<std::size_t>(row + down) * columns_ + column + across];
    if (!line.known) return true;
    far += weight * line.far;
    near += weight * line.near;
    sigma_px += weight * line.sigma_px;
  }
  const Eigen::Vector2d disparity(dx, dy), along = near - far;
  const double length2 = along.squaredNorm();
  const double part =
      length2 > 0 ? std::clamp((disparity - far).dot(along) / length2, 0.0, 1.0) : 0.0;
  const double allowed = config_.sigmas * sigma_px + config_.slack_px;
  return (disparity - far - part * along).squaredNorm() <= allowed * allowed;
}

cv::Mat1b EpipolarPrior::Contradicted(const DisparityField& field) const {
  cv::Mat1b mask = cv::Mat1b::zeros(field.valid.size());
  for (int y = 0; y < field.valid.rows; ++y) {
    for (int x = 0; x < field.valid.cols; ++x) {
      if (field.valid(y, x) != 0 && !Allows(x, y, field.dx(y, x), field.dy(y, x))) mask(y, x) = 255;
    }
  }
  return mask;
}

double EpipolarPrior::ShareRejected(const DisparityField& field) const {
  const int valid = cv::countNonZero(field.valid);
  return valid > 0 ? static_cast<double>(cv::countNonZero(Contradicted(field))) / valid : 0;
}

void EpipolarPrior::Reject(DisparityField& field) const {
  field.valid.setTo(0, Contradicted(field));
}

}  // namespace horopter::vision
