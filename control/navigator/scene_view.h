// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>

#include "control/navigator/obstacle_points.h"
#include "hardware/types/time.h"
#include "vision/reconstruction/point_field.h"
#include "vision/regions/region.h"

namespace horopter::control {

/// What the navigator gets from one stereo frame: regions of the left image and, for each of its
/// pixels, the point that could be hit there, or the point of the floor. All maps have the left
/// image's size.
struct SceneView {
  hardware::Time t_capture{};
  vision::RegionMap regions;
  cv::Mat3f obstacles_B;  ///< Split(): (x, y, z) in the base at t_capture [m]; NaN: free,
                          ///< floor or unknown

  cv::Mat3f floor_B;  ///< Split(): likewise; NaN: no floor seen

  cv::Size size() const { return obstacles_B.size(); }
};

/// @param points_B in the base frame at t_capture
/// @throws std::invalid_argument when labels and points differ in size
SceneView MakeSceneView(hardware::Time t_capture, vision::RegionMap regions, SplitPoints points_B);

}  // namespace horopter::control
