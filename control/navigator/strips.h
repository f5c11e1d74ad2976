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

/// How a view is cut into a left, a central and a right area.
struct StripConfig {
  double central_fraction = 0.40;       ///< kCentralImage: of the image width
  double corridor_half_width_m = 0.20;  ///< kCorridor: half the robot's width and a margin
  int min_pixels = 25;                  ///< a region with fewer in an area does not count there
  double near_percentile = 0.05;        ///< of a region's distances in an area: the minimum that a
                                        ///< few wrong pixels cannot make
  bool edges_count = true;              ///< edge pixels (label 0) form a region of their own: a
                                        ///< thin or richly textured thing may have no other

  std::vector<hardware::FieldError> Validate() const;
};

/// A region as far as it lies in one area.
struct Obstacle {
  int label = 0;  ///< of the region; 0: edge pixels; -1: remembered, no longer in view
  Strip strip = Strip::kCentre;
  int count = 0;  ///< pixels with a distance in this area (remembered: cells)
  double near_m = std::numeric_limits<double>::infinity();  ///< near percentile of distance
};

/// The nearest thing of each area; nothing where the area has none.
struct StripMeasurements {
  std::optional<Obstacle> left;
  std::optional<Obstacle> centre;
  std::optional<Obstacle> right;

  /// Distance of the area's nearest thing [m]; infinite when it is free.
  double near_m(Strip strip) const;
};

/// Statistics of every region in every area, reduced to the nearest of each. One region may span
/// all three (regions merge): only its pixels inside an area count there.
///
/// kCentralImage: areas are image columns; distance is x_B. kCorridor: areas are left of, in and
/// right of the corridor of half width `corridor_half_width_m` that runs from the base's origin
/// along `bearing_rad` (positive to the left); distance is measured along the corridor.
StripMeasurements MeasureStrips(const SceneView& view, ObstacleTest test, double bearing_rad,
                                const StripConfig& config);

}  // namespace horopter::control
