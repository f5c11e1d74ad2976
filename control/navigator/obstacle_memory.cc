// SPDX-License-Identifier: Apache-2.0
#include "control/navigator/obstacle_memory.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "hardware/types/field_checker.h"

namespace horopter::control {

using hardware::Pose2;
using hardware::Time;

namespace {

/// Nearest obstacle of each direction of a view, seen from the base's origin, 3 degrees a bin.
class Panorama {
 public:
  explicit Panorama(const cv::Mat3f& obstacles_B) {
    nearest_.fill(std::numeric_limits<double>::infinity());
    for (int v = 0; v < obstacles_B.rows; ++v) {
      for (int u = 0; u < obstacles_B.cols; ++u) {
        const cv::Vec3f& p = obstacles_B(v, u);
        if (std::isnan(p[0])) continue;
        double& nearest = nearest_[Bin(p[0], p[1])];
        nearest = std::min<double>(nearest, std::hypot(p[0], p[1]));
      }
    }
  }

  /// Whether the view saw obstacles in that direction, all of them beyond `range_m`.
  bool SeesBeyond(const Eigen::Vector2d& p_B, double range_m) const {
    const double nearest = nearest_[Bin(p_B.x(), p_B.y())];
    return std::isfinite(nearest) && nearest > range_m;
  }

 private:
  static constexpr int kBins = 120;

  static int Bin(double x, double y) {
    const double turn = std::atan2(y, x) / (2 * M_PI) + 0.5;  // 0 to 1
    return std::min(static_cast<int>(turn * kBins), kBins - 1);
  }

  std::array<double, kBins> nearest_;
};

Eigen::Vector2d InBase(const Pose2& X_OB, double x_O, double y_O) {
  const double c = std::cos(X_OB.heading_rad), s = std::sin(X_OB.heading_rad);
  const double dx = x_O - X_OB.x_m, dy = y_O - X_OB.y_m;
  return {c * dx + s * dy, c * dy - s * dx};
}

}  // namespace

std::vector<hardware::FieldError> ObstacleMemoryConfig::Validate() const {
  hardware::FieldChecker check("memory.");
  check.Require(cell_m >= 0.005 && cell_m <= 0.5, "cell_m", cell_m,
                "must be between 0.005 and 0.5");
  check.Require(std::isfinite(keep_s) && keep_s >= 0, "keep_s", keep_s,
                "must be finite and not negative");
  check.Require(min_pixels >= 1, "min_pixels", min_pixels, "must be at least 1");
  check.Require(max_range_m > 0 && max_range_m <= 10, "max_range_m", max_range_m,
                "must be above 0 and at most 10");
  check.Require(confirm_beyond_m >= 0, "confirm_beyond_m", confirm_beyond_m,
                "must not be negative");
  check.Require(clear_min_m >= 0, "clear_min_m", clear_min_m, "must not be negative");
  return check.Take();
}

ObstacleMemory::ObstacleMemory(const ObstacleMemoryConfig& config)
    : config_((hardware::ThrowIfAny(config.Validate()), config)) {}

ObstacleMemory::Cell ObstacleMemory::CellOf(double x_O, double y_O) const {
  return {static_cast<std::int32_t>(std::floor(x_O / config_.cell_m)),
          static_cast<std::int32_t>(std::floor(y_O / config_.cell_m))};
}

void ObstacleMemory::Add(const SceneView& view, const Pose2& X_OB) {
  UpdateSeen(view, X_OB);
  ClearSeenPast(view, X_OB);
  const hardware::Duration keep = hardware::FromSeconds(config_.keep_s);
  std::erase_if(cells_, [&](const auto& cell) { return view.t_capture - cell.second.last > keep; });
}

ObstacleMemory::Window ObstacleMemory::CountPixels(const cv::Mat3f& points_B,
                                                   const Pose2& X_OB) const {
  const int reach = static_cast<int>(std::ceil(config_.max_range_m / config_.cell_m)) + 1;
  const Cell centre = CellOf(X_OB.x_m, X_OB.y_m);
  Window window{{centre.first - reach, centre.second - reach}, 2 * reach + 1, {}};
  window.pixels.assign(static_cast<std::size_t>(window.side) * window.side, 0);
  const double c = std::cos(X_OB.heading_rad), s = std::sin(X_OB.heading_rad);
  const double max_range2 = config_.max_range_m * config_.max_range_m;
  for (int v = 0; v < points_B.rows; ++v) {
    for (int u = 0; u < points_B.cols; ++u) {
      const double x = points_B(v, u)[0], y = points_B(v, u)[1];
      if (!(x * x + y * y <= max_range2)) continue;  // NaN too
      const Cell cell = CellOf(X_OB.x_m + c * x - s * y, X_OB.y_m + s * x + c * y);
      ++window.pixels[(cell.first - window.corner.first) * window.side + cell.second -
                      window.corner.second];
    }
  }
  return window;
}

void ObstacleMemory::UpdateSeen(const SceneView& view, const Pose2& X_OB) {
  const Window standing = CountPixels(view.obstacles_B, X_OB);
  const Window floor = CountPixels(view.floor_B, X_OB);
  for (int i = 0; i < standing.side; ++i) {
    for (int j = 0; j < standing.side; ++j) {
      const int obstacle_px = standing.pixels[i * standing.side + j];
      const int floor_px = floor.pixels[i * standing.side + j];
      const Cell cell{standing.corner.first + i, standing.corner.second + j};
      if (obstacle_px >= config_.min_pixels && 2 * obstacle_px >= floor_px) {
        const bool confirmed = SeenBefore(cell, view.t_capture);
        Seen& seen = cells_.try_emplace(cell, Seen{view.t_capture, view.t_capture}).first->second;
        seen.last = view.t_capture;
        seen.confirmed = seen.confirmed || confirmed;
      } else if (floor_px >= config_.min_pixels) {
        cells_.erase(cell);
      }
    }
  }
}

bool ObstacleMemory::SeenBefore(const Cell& cell, Time now) const {
  constexpr int kAbout = 2;
  for (int i = -kAbout; i <= kAbout; ++i) {
    // Cells of a row of the window are neighbours in the map's order.
    auto it = cells_.lower_bound({cell.first + i, cell.second - kAbout});
    for (; it != cells_.end() && it->first <= Cell{cell.first + i, cell.second + kAbout}; ++it) {
      if (it->second.first != now) return true;
    }
  }
  return false;
}

void ObstacleMemory::ClearSeenPast(const SceneView& view, const Pose2& X_OB) {
  const Panorama panorama(view.obstacles_B);
  const double margin = 3 * config_.cell_m;
  std::erase_if(cells_, [&](const auto& cell) {
    if (cell.second.last == view.t_capture) return false;
    const Eigen::Vector2d p_B = InBase(X_OB, (cell.first.first + 0.5) * config_.cell_m,
                                       (cell.first.second + 0.5) * config_.cell_m);
    const double range = p_B.norm();
    return range >= config_.clear_min_m && panorama.SeesBeyond(p_B, range + margin);
  });
}

std::vector<Eigen::Vector2d> ObstacleMemory::PointsInBase(const Pose2& X_OB,
                                                          Certainty certainty) const {
  std::vector<Eigen::Vector2d> points;
  points.reserve(cells_.size());
  for (const auto& [cell, seen] : cells_) {
    const Eigen::Vector2d p_B =
        InBase(X_OB, (cell.first + 0.5) * config_.cell_m, (cell.second + 0.5) * config_.cell_m);
    if (certainty == Certainty::kAny || seen.confirmed || p_B.norm() <= config_.confirm_beyond_m) {
      points.push_back(p_B);
    }
  }
  return points;
}

}  // namespace horopter::control
