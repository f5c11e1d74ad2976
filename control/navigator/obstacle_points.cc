// SPDX-License-Identifier: Apache-2.0
#include "control/navigator/obstacle_points.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/core.hpp>
#include <string>

#include "hardware/types/field_checker.h"

namespace horopter::control {

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// Range on the ground of every point that is in front, within range and residual; NaN elsewhere.
cv::Mat1f UsableRanges(const vision::PointField& points_B, const ObstacleConfig& config) {
  cv::Mat1f ranges(points_B.points.size(), kNan);
  for (int v = 0; v < ranges.rows; ++v) {
    for (int u = 0; u < ranges.cols; ++u) {
      const cv::Vec3f& p = points_B.points(v, u);
      const double range = std::sqrt(static_cast<double>(p[0]) * p[0] + p[1] * p[1]);
      // NaN fails every comparison.
      if (p[0] > 0 && range >= config.min_range_m && range <= config.max_range_m &&
          points_B.residual_m(v, u) <= config.max_residual_m) {
        ranges(v, u) = static_cast<float>(range);
      }
    }
  }
  return ranges;
}

/// Whether enough of the pixels around (v, u) are about as far.
bool IsSupported(const cv::Mat1f& ranges, int v, int u, const ObstacleConfig& config) {
  int missing = config.support_px;
  const float range = ranges(v, u);
  const float tolerance = static_cast<float>(config.support_tolerance) * range;
  for (int y = std::max(v - 2, 0); y <= std::min(v + 2, ranges.rows - 1) && missing > 0; ++y) {
    for (int x = std::max(u - 2, 0); x <= std::min(u + 2, ranges.cols - 1); ++x) {
      if (std::abs(ranges(y, x) - range) <= tolerance && (y != v || x != u)) --missing;
    }
  }
  return missing <= 0;
}

}  // namespace

std::vector<hardware::FieldError> ObstacleConfig::Validate() const {
  hardware::FieldChecker check("obstacle.");
  check.Require(std::isfinite(floor_m), "floor_m", floor_m, "must be finite");
  check.Require(pit_m < floor_m, "pit_m", pit_m, "must be below floor_m");
  check.Require(robot_height_m > floor_m, "robot_height_m", robot_height_m,
                "must be above floor_m");
  check.Require(min_range_m >= 0, "min_range_m", min_range_m, "must not be negative");
  check.Require(max_range_m > min_range_m, "max_range_m", max_range_m, "must be above min_range_m");
  check.Require(max_residual_m > 0, "max_residual_m", max_residual_m, "must be positive");
  check.Require(support_px >= 0 && support_px <= 24, "support_px", support_px,
                "must be between 0 and 24");
  check.Require(support_tolerance > 0, "support_tolerance", support_tolerance, "must be positive");
  return check.Take();
}

SplitPoints Split(const vision::PointField& points_B, const ObstacleConfig& config) {
  hardware::ThrowIfAny(config.Validate());
  const cv::Mat1f ranges = UsableRanges(points_B, config);
  SplitPoints split{cv::Mat3f(ranges.size(), cv::Vec3f::all(kNan)),
                    cv::Mat3f(ranges.size(), cv::Vec3f::all(kNan))};
  for (int v = 0; v < ranges.rows; ++v) {
    for (int u = 0; u < ranges.cols; ++u) {
      const cv::Vec3f& p = points_B.points(v, u);
      if (std::isnan(ranges(v, u)) || p[2] < config.pit_m || p[2] > config.robot_height_m ||
          !IsSupported(ranges, v, u, config)) {
        continue;
      }
      (p[2] < config.floor_m ? split.floor : split.obstacles)(v, u) = p;
    }
  }
  return split;
}

}  // namespace horopter::control
