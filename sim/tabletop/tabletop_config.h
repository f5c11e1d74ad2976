// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hardware/types/config_error.h"

namespace horopter::sim {

/// Where the objects stand.
struct ArrangementConfig {
  bool shuffle = true;  ///< drawn by the seed; false: where the scene file has them
  /// An object's front turns away from the viewpoint by up to this, either way. The paper's
  /// recognition holds to 40 or 60 deg.
  double yaw_spread_rad = 25 * M_PI / 180;
  /// Middle of the table that things stand on: along its x and y. The default is what the
  /// peripheral cameras see of it at once.
  double depth_m = 0.75;
  double width_m = 1.1;
  double gap_m = 0.02;  ///< left free between any two things, and to the table's edge
  /// No more of an object than this is hidden behind the other objects (share of what the viewpoint
  /// would see of it).
  double max_hidden = 0.05;
};

/// Things that belong to no experiment.
struct ClutterConfig {
  int count = 0;            ///< how many of the scene's stand on the table
  double max_hidden = 0.4;  ///< no more of an object than this is hidden, all told
};

/// One object stands in front of another.
struct OcclusionConfig {
  std::string target = "sugar";
  std::string by = "bottle";
  double fraction = 0.4;  ///< share of the target, as the viewpoint sees it alone, that is hidden
};

/// The lamp, which throws the shadows; brightness and colour hold for all lights. Each value is
/// the nominal one plus a draw from its spread, either way.
struct LightConfig {
  double azimuth_rad =
      131 * M_PI / 180;  ///< where it stands from the table's middle: 0 along W's x
  double elevation_rad = 64 * M_PI / 180;  ///< above the table
  double brightness = 1;                   ///< 1: as the scene has it
  double colour_temperature_k = 6500;      ///< 6500: white; less: yellower
  double azimuth_spread_rad = 0;
  double elevation_spread_rad = 0;
  double brightness_spread = 0;
  double colour_temperature_spread_k = 0;
};

/// What is varied on a tabletop. Every part draws from random streams of its own.
struct TabletopConfig {
  ArrangementConfig arrangement;
  ClutterConfig clutter;
  std::optional<OcclusionConfig> occlusion;
  LightConfig light;
  std::string background;  ///< one of the scene's (Backgrounds()); empty: drawn
  bool textures = true;    ///< painted by the seed; false: as seed 0 paints them
  /// From where objects face and hide each other [m, W]; nothing: midway between the peripheral
  /// cameras as they stand.
  std::optional<Eigen::Vector3d> viewpoint_W;

  /// Every bad field, those apart that only a scene can tell.
  std::vector<hardware::FieldError> Validate() const;
};

}  // namespace horopter::sim
