// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "hardware/types/config_error.h"
#include "vision/reconstruction/point_field.h"

namespace horopter::control {

/// Which reconstructed points could be hit. Lengths in metres, in the base frame B (origin on the
/// floor below the robot's centre; x forward, y left, z up).
struct ObstacleConfig {
  double floor_m = 0.03;            ///< points below are floor
  double pit_m = -0.15;             ///< points below this are mismatches
  double robot_height_m = 0.45;     ///< points above pass over the head
  double min_range_m = 0.10;        ///< nearer points would be inside the robot: mismatches
  double max_range_m = 3.0;         ///< further ones are too uncertain to decide by
  double max_residual_m = 0.02;     ///< rays that pass each other further apart are mismatches
  int support_px = 5;               ///< points of the 5x5 pixels around that must be about as far;
                                    ///< 0: lone points count too
  double support_tolerance = 0.10;  ///< "about as far": relative difference of range

  std::vector<hardware::FieldError> Validate() const;
};

/// Reconstructed points by what they mean for a robot on the floor; NaN where a pixel has none.
struct SplitPoints {
  cv::Mat3f obstacles;  ///< could be hit: between floor and robot height
  cv::Mat3f floor;      ///< below: where floor is seen nothing stands
};

/// Sorts out the points that are finite, in front (x > 0), within range (of the point's distance on
/// the plane) and residual, and supported by their neighbours.
/// @param points_B points in B
/// @throws hardware::ConfigError
SplitPoints Split(const vision::PointField& points_B, const ObstacleConfig& config);

}  // namespace horopter::control
