// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/core.hpp>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include "control/navigator/scene_view.h"
#include "hardware/types/pose.h"
#include "hardware/types/time.h"

namespace horopter::control {

/// An upright cylinder on the floor.
struct Pillar {
  Eigen::Vector2d p_O;
  double radius_m = 0.15;
};

/// What stereo does to a view.
struct ToyNoise {
  double relative_at_1m = 0;  ///< deviation of range, relative, growing in proportion to range
  double missing = 0;         ///< part of the pixels without a point
  double mismatched = 0;      ///< part of the rest at a wrong range between 0.15 and 3 m
  int seed = 0;
};

/// A floor with pillars, seen by a camera 0.3 m above the robot's centre with a
/// horizontal field of view of 60 degrees, without error unless AddNoise() says so. Every pillar is
/// a region of its own.
class ToyWorld {
 public:
  explicit ToyWorld(std::vector<Pillar> pillars) : pillars_(std::move(pillars)) {}

  const std::vector<Pillar>& pillars() const { return pillars_; }

  void AddNoise(const ToyNoise& noise) { noise_ = noise; }

  /// Distance from a round robot's rim to the nearest pillar; negative: contact.
  double Clearance(const hardware::Pose2& X_OB, double robot_radius_m) const {
    double least = std::numeric_limits<double>::infinity();
    for (const Pillar& p : pillars_) {
      const double apart = std::hypot(p.p_O.x() - X_OB.x_m, p.p_O.y() - X_OB.y_m);
      least = std::min(least, apart - p.radius_m - robot_radius_m);
    }
    return least;
  }

  /// What the camera sees when it is turned left of the robot's heading by `camera_pan_rad`.
  SceneView View(hardware::Time t, const hardware::Pose2& X_OB, double camera_pan_rad) const {
    constexpr int kWidth = 100, kHeight = 75;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const double f = kWidth / 2.0 / std::tan(M_PI / 6);
    vision::RegionMap regions;
    regions.labels = cv::Mat1i(kHeight, kWidth, 0);
    for (std::size_t i = 0; i < pillars_.size(); ++i) {
      vision::Region region;
      region.label = static_cast<int>(i) + 1;
      regions.regions.push_back(region);
    }
    vision::PointField points{cv::Mat3f(kHeight, kWidth, cv::Vec3f::all(nan)),
                              cv::Mat1f(kHeight, kWidth, 0.f)};
    std::mt19937 generator((noise_ ? noise_->seed : 0) +
                           static_cast<int>(t.time_since_epoch().count() % 999983));
    for (int u = 0; u < kWidth; ++u) {
      const double bearing = camera_pan_rad - std::atan((u - (kWidth - 1) / 2.0) / f);
      const auto [range, label] = CastRay(X_OB, bearing);
      const double per_pixel = 1 / (f * std::cos(bearing - camera_pan_rad));
      for (int v = 0; v < kHeight; ++v) {
        const double down = (v - (kHeight - 1) / 2.0) * per_pixel;  // metres per metre of range
        const double to_floor = down > 0 ? kEyeHeight / down : std::numeric_limits<double>::max();
        const double r = Disturbed(std::min(range, to_floor), generator);
        if (!(r < 20)) continue;
        points.points(v, u) = {static_cast<float>(r * std::cos(bearing)),
                               static_cast<float>(r * std::sin(bearing)),
                               static_cast<float>(kEyeHeight - r * down)};
        if (range <= to_floor) regions.labels(v, u) = label;
      }
    }
    return MakeSceneView(t, regions, Split(points, {}));
  }

 private:
  static constexpr double kEyeHeight = 0.3;

  /// A range as stereo would measure it; NaN: not at all.
  double Disturbed(double range, std::mt19937& generator) const {
    if (!noise_) return range;
    std::uniform_real_distribution<double> uniform(0, 1), anywhere(0.15, 3);
    std::normal_distribution<double> normal(0, 1);
    if (uniform(generator) < noise_->missing) return std::numeric_limits<double>::quiet_NaN();
    if (uniform(generator) < noise_->mismatched) return anywhere(generator);
    return range * (1 + noise_->relative_at_1m * range * normal(generator));
  }

  /// Nearest pillar along a bearing: its range on the ground and its label.
  std::pair<double, int> CastRay(const hardware::Pose2& X_OB, double bearing) const {
    const double angle = X_OB.heading_rad + bearing;
    const Eigen::Vector2d d(std::cos(angle), std::sin(angle));
    std::pair<double, int> nearest{std::numeric_limits<double>::infinity(), 0};
    for (std::size_t i = 0; i < pillars_.size(); ++i) {
      const Eigen::Vector2d to = pillars_[i].p_O - Eigen::Vector2d(X_OB.x_m, X_OB.y_m);
      const double along = to.dot(d);
      const double inside =
          pillars_[i].radius_m * pillars_[i].radius_m - to.squaredNorm() + along * along;
      if (along <= 0 || inside < 0) continue;
      const double range = along - std::sqrt(inside);
      if (range < nearest.first) nearest = {range, static_cast<int>(i) + 1};
    }
    return nearest;
  }

  std::vector<Pillar> pillars_;
  std::optional<ToyNoise> noise_;
};

}  // namespace horopter::control
