// SPDX-License-Identifier: Apache-2.0
#include "control/navigator/obstacle_points.h"

#include <cmath>
#include <limits>
#include <opencv2/core.hpp>
#include <string>

namespace horopter::control {

std::vector<hardware::FieldError> ObstacleConfig::Validate() const {
  std::vector<hardware::FieldError> errors;
  const auto require = [&errors](bool good, const char* field, double value, const char* rule) {
    if (!good) errors.push_back({field, std::to_string(value), rule});
  };
  require(std::isfinite(floor_m), "obstacle.floor_m", floor_m, "must be finite");
  require(robot_height_m > floor_m, "obstacle.robot_height_m", robot_height_m,
          "must be above floor_m");
  require(min_range_m >= 0, "obstacle.min_range_m", min_range_m, "must not be negative");
  require(max_range_m > min_range_m, "obstacle.max_range_m", max_range_m,
          "must be above min_range_m");
  require(max_residual_m > 0, "obstacle.max_residual_m", max_residual_m, "must be positive");
  return errors;
}

cv::Mat3f ObstaclePoints(const vision::PointField& points_B, const ObstacleConfig& config) {
  hardware::ThrowIfAny(config.Validate());
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  cv::Mat3f kept(points_B.points.size(), cv::Vec3f::all(kNan));
  for (int v = 0; v < kept.rows; ++v) {
    for (int u = 0; u < kept.cols; ++u) {
      const cv::Vec3f& p = points_B.points(v, u);
      const double range = std::hypot(p[0], p[1]);
      // NaN fails every comparison.
      if (p[0] > 0 && p[2] >= config.floor_m && p[2] <= config.robot_height_m &&
          range >= config.min_range_m && range <= config.max_range_m &&
          points_B.residual_m(v, u) <= config.max_residual_m) {
        kept(v, u) = p;
      }
    }
  }
  return kept;
}

cv::Mat1f ObstacleDepth(const vision::PointField& points_B, const ObstacleConfig& config) {
  cv::Mat1f depth;
  cv::extractChannel(ObstaclePoints(points_B, config), depth, 0);
  return depth;
}

}  // namespace horopter::control
