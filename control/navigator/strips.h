// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>
#include <vector>

#include "control/navigator/scene_view.h"
#include "hardware/types/config_error.h"

namespace horopter::control {

/// What "in front" means.
enum class ObstacleTest {
  kCentralImage,  ///< the central area of the left image (the paper)
  kCorridor,      ///< the ground that the robot would sweep
};

enum class Strip { kLeft, kCentre, kRight };

/// The right of kLeft, the left of kRight. @pre not the centre
Strip OtherSide(Strip side);

/// How a view is cut into a left, a central and a right area.
struct StripConfig {
  double central_fraction = 0.40;       ///< kCentralImage: of the image width
  double corridor_half_width_m = 0.28;  ///< kCorridor: half the robot's diagonal and a margin
  int min_pixels = 25;                  ///< a region with fewer in an area does not count there
  double near_fraction = 0.05;          ///< of a region's pixels in an area may be nearer than
                                        ///< its near_m, so that a few wrong ones do not make it
  bool edges_count = true;              ///< edge pixels (label 0) form a region of their own: a
                                        ///< thin or richly textured thing may have no other

  std::vector<hardware::FieldError> Validate() const;
};

/// A region as far as it lies in one area.
struct Obstacle {
  static constexpr int kRemembered = -1;

  int label = 0;  ///< of the region; 0: edge pixels; kRemembered: cells of the ObstacleMemory
  int count = 0;  ///< its pixels that stand in this area (remembered: cells)
  double near_m = std::numeric_limits<double>::infinity();  ///< distance, see MeasureStrips()
};

/// The nearest thing of each area; nothing where the area has none.
struct StripMeasurements {
  std::optional<Obstacle> left;
  std::optional<Obstacle> centre;
  std::optional<Obstacle> right;

  std::optional<Obstacle>& operator[](Strip strip);
  /// Distance of the area's nearest thing [m]; infinite when it is free.
  double near_m(Strip strip) const;
};

/// Statistics of every region in every area, reduced to the nearest of each. One region may span
/// all three (regions merge): only its pixels inside an area count there. Floor pixels count as
/// infinitely far, so that a region is near only when `near_fraction` of what is seen of it in the
/// area is: a few mismatches on the floor are no obstacle.
///
/// kCentralImage: areas are columns of the image; distance is x_B. kCorridor: the corridor of half
/// width `corridor_half_width_m` runs from the base's origin along `bearing_rad` (positive to the
/// left); distance is measured along it inside, and from the base's origin to the left and right
/// of it. What lies behind the origin, seen along the corridor, is in no area.
StripMeasurements MeasureStrips(const SceneView& view, ObstacleTest test, double bearing_rad,
                                const StripConfig& config);

/// The corridor's areas for bare points of the ground (x, y) in the base frame.
StripMeasurements MeasurePoints(const std::vector<Eigen::Vector2d>& points_B, double bearing_rad,
                                const StripConfig& config);

/// The nearer thing of each area.
StripMeasurements Nearest(const StripMeasurements& a, const StripMeasurements& b);

}  // namespace horopter::control
