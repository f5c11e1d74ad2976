// SPDX-License-Identifier: Apache-2.0
#include "control/navigator/strips.h"

#include <array>
#include <cmath>

#include "hardware/types/field_checker.h"
#include "vision/regions/nearest_rank.h"

namespace horopter::control {
namespace {

constexpr Strip kStrips[] = {Strip::kLeft, Strip::kCentre, Strip::kRight};

/// The floor is no obstacle at any distance, but it counts among a region's pixels.
constexpr float kFloor = std::numeric_limits<float>::infinity();

/// A region's pixels in one area.
struct PixelsInArea {
  std::vector<float> distances;
  int standing = 0;  ///< those that are not floor
};

struct Place {
  Strip strip;
  double distance_m;
};

/// Where a point of the ground is with respect to a corridor.
class Corridor {
 public:
  Corridor(double bearing_rad, double half_width_m)
      : cos_(std::cos(bearing_rad)), sin_(std::sin(bearing_rad)), half_width_m_(half_width_m) {}

  std::optional<Place> Locate(double x, double y) const {
    const double along = x * cos_ + y * sin_;
    const double across = y * cos_ - x * sin_;
    if (!(along > 0)) return std::nullopt;
    if (across > half_width_m_) return Place{Strip::kLeft, std::hypot(x, y)};
    if (across < -half_width_m_) return Place{Strip::kRight, std::hypot(x, y)};
    return Place{Strip::kCentre, along};
  }

 private:
  double cos_;
  double sin_;
  double half_width_m_;
};

Strip StripOfColumn(int u, int width, double central_fraction) {
  const double from_centre = (u - (width - 1) / 2.0) / width;
  if (from_centre < -central_fraction / 2) return Strip::kLeft;
  if (from_centre > central_fraction / 2) return Strip::kRight;
  return Strip::kCentre;
}

void KeepNearer(std::optional<Obstacle>& nearest, const Obstacle& candidate) {
  if (!nearest || candidate.near_m < nearest->near_m) nearest = candidate;
}

}  // namespace

Strip OtherSide(Strip side) { return side == Strip::kLeft ? Strip::kRight : Strip::kLeft; }

std::vector<hardware::FieldError> StripConfig::Validate() const {
  hardware::FieldChecker check("strips.");
  check.Require(central_fraction > 0 && central_fraction < 1, "central_fraction", central_fraction,
                "must be between 0 and 1, both excluded");
  check.Require(std::isfinite(corridor_half_width_m) && corridor_half_width_m > 0,
                "corridor_half_width_m", corridor_half_width_m, "must be finite and positive");
  check.Require(min_pixels >= 1, "min_pixels", min_pixels, "must be at least 1");
  check.Require(near_fraction >= 0 && near_fraction < 1, "near_fraction", near_fraction,
                "must be at least 0 and less than 1");
  return check.Take();
}

std::optional<Obstacle>& StripMeasurements::operator[](Strip strip) {
  return strip == Strip::kLeft ? left : strip == Strip::kRight ? right : centre;
}

double StripMeasurements::near_m(Strip strip) const {
  const auto& obstacle = strip == Strip::kLeft ? left : strip == Strip::kRight ? right : centre;
  return obstacle ? obstacle->near_m : std::numeric_limits<double>::infinity();
}

StripMeasurements MeasureStrips(const SceneView& view, ObstacleTest test, double bearing_rad,
                                const StripConfig& config) {
  const Corridor corridor(bearing_rad, config.corridor_half_width_m);
  const int width = view.obstacles_B.cols;
  const auto locate = [&](int u, const cv::Vec3f& p) -> std::optional<Place> {
    if (std::isnan(p[0])) return std::nullopt;
    if (test == ObstacleTest::kCorridor) return corridor.Locate(p[0], p[1]);
    return Place{StripOfColumn(u, width, config.central_fraction), p[0]};
  };

  std::vector<std::array<PixelsInArea, 3>> areas(view.regions.regions.size() + 1);
  for (int v = 0; v < view.obstacles_B.rows; ++v) {
    for (int u = 0; u < width; ++u) {
      const int label = view.regions.labels(v, u);
      if (label == 0 && !config.edges_count) continue;
      const bool stands = !std::isnan(view.obstacles_B(v, u)[0]);
      const auto place = locate(u, stands ? view.obstacles_B(v, u) : view.floor_B(v, u));
      if (!place) continue;
      PixelsInArea& area = areas[label][static_cast<int>(place->strip)];
      if (stands) ++area.standing;
      area.distances.push_back(stands ? static_cast<float>(place->distance_m) : kFloor);
    }
  }

  StripMeasurements measured;
  for (std::size_t label = 0; label < areas.size(); ++label) {
    for (const Strip strip : kStrips) {
      PixelsInArea& area = areas[label][static_cast<int>(strip)];
      if (area.standing < config.min_pixels) continue;
      const double near = vision::NearestRank(area.distances, config.near_fraction);
      if (std::isinf(near)) continue;
      KeepNearer(measured[strip], {static_cast<int>(label), area.standing, near});
    }
  }
  return measured;
}

StripMeasurements MeasurePoints(const std::vector<Eigen::Vector2d>& points_B, double bearing_rad,
                                const StripConfig& config) {
  const Corridor corridor(bearing_rad, config.corridor_half_width_m);
  StripMeasurements measured;
  for (const Eigen::Vector2d& p : points_B) {
    const auto place = corridor.Locate(p.x(), p.y());
    if (!place) continue;
    std::optional<Obstacle>& nearest = measured[place->strip];
    const int count = (nearest ? nearest->count : 0) + 1;
    KeepNearer(nearest, {Obstacle::kRemembered, count, place->distance_m});
    nearest->count = count;
  }
  return measured;
}

StripMeasurements Nearest(const StripMeasurements& a, const StripMeasurements& b) {
  StripMeasurements nearest = a;
  if (b.left) KeepNearer(nearest.left, *b.left);
  if (b.centre) KeepNearer(nearest.centre, *b.centre);
  if (b.right) KeepNearer(nearest.right, *b.right);
  return nearest;
}

}  // namespace horopter::control
