// SPDX-License-Identifier: Apache-2.0
#include "control/navigator/scene_view.h"

#include <stdexcept>
#include <string>
#include <utility>

namespace horopter::control {

SceneView MakeSceneView(hardware::Time t_capture, vision::RegionMap regions, SplitPoints points_B) {
  if (regions.labels.size() != points_B.obstacles.size()) {
    throw std::invalid_argument("scene view: labels are " + std::to_string(regions.labels.cols) +
                                "x" + std::to_string(regions.labels.rows) + ", points " +
                                std::to_string(points_B.obstacles.cols) + "x" +
                                std::to_string(points_B.obstacles.rows) +
                                ": both must have the left image's size");
  }
  return {t_capture, std::move(regions), std::move(points_B.obstacles), std::move(points_B.floor)};
}

}  // namespace horopter::control
