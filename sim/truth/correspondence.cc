// SPDX-License-Identifier: Apache-2.0
#include "sim/truth/true_disparity.h"

#include <Eigen/LU>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

namespace horopter::sim {
namespace {

using hardware::CameraModel;
using hardware::Pose;

/// Relative difference in depth below which two surfaces count as one: thirty times what a 24 bit
/// depth buffer and the renderer's interpolation leave.
constexpr double kDepthTolerance = 1e-3;

/// Direction (z = 1) of every pixel's centre; NaN where the lens model has none.
class Rays {
 public:
  explicit Rays(const CameraModel& camera) : width_(camera.width()) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    rays_.reserve(static_cast<std::size_t>(width_) * static_cast<std::size_t>(camera.height()));
    for (int y = 0; y < camera.height(); ++y) {
      for (int x = 0; x < width_; ++x) {
        rays_.push_back(
            camera.Unproject(Eigen::Vector2d(x, y)).value_or(Eigen::Vector3d::Constant(kNone)));
      }
    }
  }
  const Eigen::Vector3d& operator()(int y, int x) const {
    return rays_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                 static_cast<std::size_t>(x)];
  }

 private:
  int width_;
  std::vector<Eigen::Vector3d> rays_;
};

struct Neighbour {
  int y;
  int x;
  double inverse_depth;
};

/// Of the two neighbours along one image axis that belong to the same object, the one whose inverse
/// depth differs less: the other may lie across a fold or a gap of that object.
std::optional<Neighbour> FlattestNeighbour(const EyeTruth& eye, int y, int x, int step_y,
                                           int step_x) {
  const double own = 1.0 / eye.depth(y, x);
  std::optional<Neighbour> best;
  for (const int sign : {1, -1}) {
    const int v = y + sign * step_y, u = x + sign * step_x;
    if (v < 0 || u < 0 || v >= eye.depth.rows || u >= eye.depth.cols) continue;
    if (eye.ids(v, u) != eye.ids(y, x)) continue;
    const double inverse = 1.0 / eye.depth(v, u);
    if (!best || std::abs(inverse - own) < std::abs(best->inverse_depth - own)) {
      best = Neighbour{v, u, inverse};
    }
  }
  return best;
}

/// Tangent plane g of the surface at a pixel, in the eye's frame: g . p = 1 for points p on it, so
/// that 1/z = g . ray. Fronto-parallel along an axis where no neighbour shows the object.
Eigen::Vector3d TangentPlane(const EyeTruth& eye, const Rays& rays, int y, int x) {
  const double own = 1.0 / eye.depth(y, x);
  Eigen::Matrix2d ray_step = Eigen::Matrix2d::Identity();
  Eigen::Vector2d inverse_step = Eigen::Vector2d::Zero();
  const std::optional<Neighbour> neighbours[] = {FlattestNeighbour(eye, y, x, 0, 1),
                                                 FlattestNeighbour(eye, y, x, 1, 0)};
  for (int axis = 0; axis < 2; ++axis) {
    if (!neighbours[axis]) continue;
    const auto& [v, u, inverse] = *neighbours[axis];
    ray_step.row(axis) = (rays(v, u) - rays(y, x)).head<2>();
    inverse_step[axis] = inverse - own;
  }
  const Eigen::Vector2d slope = ray_step.inverse() * inverse_step;
  if (!slope.allFinite()) return {0, 0, own};
  return {slope.x(), slope.y(), own - slope.dot(rays(y, x).head<2>())};
}

/// The plane seen from another eye. @return nothing when that eye is behind it.
std::optional<Eigen::Vector3d> TransformPlane(const Eigen::Vector3d& g_L, const Pose& X_LR) {
  const double scale = 1 - g_L.dot(X_LR.translation());
  if (scale <= 0) return std::nullopt;
  return X_LR.linear().transpose() * g_L / scale;
}

/// Holds the right pixels around `pixel` against a point of object `id` at depth `z`.
Visibility Classify(const EyeTruth& right, const Rays& rays, const Eigen::Vector2d& pixel, double z,
                    int id, const Eigen::Vector3d& plane) {
  const int left_column = static_cast<int>(std::floor(pixel.x()));
  const int top_row = static_cast<int>(std::floor(pixel.y()));
  int covered = 0, same = 0, beyond = 0;
  for (int y = std::max(0, top_row); y <= std::min(right.depth.rows - 1, top_row + 1); ++y) {
    for (int x = std::max(0, left_column); x <= std::min(right.depth.cols - 1, left_column + 1);
         ++x) {
      const double inverse_expected = std::max(plane.dot(rays(y, x)), 1.0 / z);
      const double ratio = right.depth(y, x) * inverse_expected;  // 1: where the plane is
      if (ratio < 1 - kDepthTolerance) {
        ++covered;
      } else if (right.ids(y, x) == id) {
        ++same;
      } else if (ratio > 1 + kDepthTolerance) {
        ++beyond;
      }
    }
  }
  if (covered == 0 && same > 0) return Visibility::kVisible;
  if (same == 0 && beyond == 0) return Visibility::kOccluded;
  return Visibility::kEdge;
}

}  // namespace

cv::Mat1b TrueDisparityField::Mask(Visibility which) const {
  return visibility == static_cast<int>(which);
}

TrueDisparityField TrueDisparity(const EyeTruth& left, const EyeTruth& right) {
  const CameraModel& left_camera = left.view.camera;
  const CameraModel& right_camera = right.view.camera;
  assert(left.depth.rows == left_camera.height() && left.depth.cols == left_camera.width());
  assert(right.depth.rows == right_camera.height() && right.depth.cols == right_camera.width());
  constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
  const Pose X_RL = right.view.X_WC.inverse() * left.view.X_WC;
  const Pose X_LR = X_RL.inverse();
  const Rays left_rays(left_camera);
  const Rays right_rays(right_camera);

  const cv::Size size = left.depth.size();
  TrueDisparityField field{cv::Mat1f(size, kNone), cv::Mat1f(size, kNone),
                           cv::Mat1b(size, static_cast<std::uint8_t>(Visibility::kNoSurface))};
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const Eigen::Vector3d p_L = left_rays(y, x) * left.depth(y, x);
      if (!p_L.allFinite()) continue;
      const Eigen::Vector3d p_R = X_RL * p_L;
      const auto pixel = right_camera.Project(p_R);
      Visibility visibility = Visibility::kOutOfView;
      if (pixel) {
        field.dx(y, x) = static_cast<float>(pixel->x() - x);
        field.dy(y, x) = static_cast<float>(pixel->y() - y);
      }
      if (pixel && right_camera.Contains(*pixel)) {
        const auto plane = TransformPlane(TangentPlane(left, left_rays, y, x), X_LR);
        visibility = plane ? Classify(right, right_rays, *pixel, p_R.z(), left.ids(y, x), *plane)
                           : Visibility::kOccluded;
      }
      field.visibility(y, x) = static_cast<std::uint8_t>(visibility);
    }
  }
  return field;
}

}  // namespace horopter::sim
