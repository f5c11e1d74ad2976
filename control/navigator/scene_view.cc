// SPDX-License-Identifier: Apache-2.0
#include "control/navigator/scene_view.h"

#include <stdexcept>
#include <string>
#include <utility>

namespace horopter::control {

SceneView MakeSceneView(hardware::Time t_capture, vision::RegionMap regions,
                        const vision::PointField& points_B, const ObstacleConfig& config) {
  if (regions.labels.size() != points_B.points.size()) {
    throw std::invalid_argument(
        "scene view: labels are " + std::to_string(regions.labels.cols) + "x" +
        std::to_string(regions.labels.rows) + ", points " + std::to_string(points_B.points.cols) +
        "x" + std::to_string(points_B.points.rows) + ": both must have the left image's size");
  }
  SplitPoints split = Split(points_B, config);
  return {t_capture, std::move(regions), std::move(split.obstacles), std::move(split.floor)};
}

}  // namespace horopter::control
