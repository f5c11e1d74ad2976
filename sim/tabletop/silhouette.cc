// SPDX-License-Identifier: Apache-2.0
#include "sim/tabletop/silhouette.h"

#include <algorithm>
#include <cmath>

namespace horopter::sim {

Silhouette::Silhouette(const Thing& thing, const hardware::Pose& X_WB,
                       const Eigen::Vector3d& viewpoint_W, int grid)
    : viewpoint_W_(viewpoint_W), centre_W_(thing.Centre(X_WB)), radius_m_(thing.radius_m()) {
  const Eigen::Vector3d ahead = centre_W_ - viewpoint_W_;
  const Eigen::Vector3d right = ahead.cross(Eigen::Vector3d::UnitZ()).normalized();
  const Eigen::Vector3d up = right.cross(ahead).normalized();
  for (int row = 0; row < grid; ++row) {
    for (int column = 0; column < grid; ++column) {
      const double u = (2 * (column + 0.5) / grid - 1) * radius_m_;
      const double v = (2 * (row + 0.5) / grid - 1) * radius_m_;
      const Eigen::Vector3d direction = (ahead + u * right + v * up).normalized();
      const auto distance = thing.Ray(X_WB, viewpoint_W_, direction);
      if (distance) rays_.push_back({direction, *distance, false});
    }
  }
}

void Silhouette::Hide(const Thing& other, const hardware::Pose& X_WO) {
  if (!MayHide(other, X_WO)) return;
  for (Ray& ray : rays_) ray.hidden = ray.hidden || Hides(ray, other, X_WO);
}

double Silhouette::hidden() const {
  const auto hidden =
      std::count_if(rays_.begin(), rays_.end(), [](const Ray& r) { return r.hidden; });
  return rays_.empty() ? 0 : static_cast<double>(hidden) / static_cast<double>(rays_.size());
}

double Silhouette::HiddenWith(const Thing& other, const hardware::Pose& X_WO) const {
  if (!MayHide(other, X_WO)) return hidden();
  const auto hidden = std::count_if(rays_.begin(), rays_.end(), [&](const Ray& ray) {
    return ray.hidden || Hides(ray, other, X_WO);
  });
  return rays_.empty() ? 0 : static_cast<double>(hidden) / static_cast<double>(rays_.size());
}

bool Silhouette::MayHide(const Thing& other, const hardware::Pose& X_WO) const {
  const Eigen::Vector3d to_this = centre_W_ - viewpoint_W_;
  const Eigen::Vector3d to_other = other.Centre(X_WO) - viewpoint_W_;
  const double angle = std::atan2(to_this.cross(to_other).norm(), to_this.dot(to_other));
  const auto spread = [](double radius, double distance) {
    return distance > radius ? std::asin(radius / distance) : M_PI;
  };
  return angle < spread(radius_m_, to_this.norm()) + spread(other.radius_m(), to_other.norm());
}

bool Silhouette::Hides(const Ray& ray, const Thing& other, const hardware::Pose& X_WO) const {
  const auto distance = other.Ray(X_WO, viewpoint_W_, ray.direction_W);
  return distance && *distance < ray.distance_m;
}

}  // namespace horopter::sim
