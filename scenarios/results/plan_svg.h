// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "scenarios/results/run_record.h"

namespace horopter::scenarios {

/// A place on the path that a frame's pictures were taken from.
struct PlanMark {
  hardware::Pose2 pose;
  std::string label;  ///< e.g. the frame's index
  std::string link;   ///< href, or empty
};

/// The plan of the room as an SVG element that stands alone or inside an HTML page, light or dark:
/// the robot's starting frame with +x to the right and +y up, axes in metres, a scale bar, the
/// room's shapes by kind, the true path over the width that the robot swept, odometry dashed,
/// goals, intermediate waypoints and marks. Without a true path the swept width follows odometry.
std::string PlanSvg(const PlanRecord& plan, const std::vector<PlanMark>& marks = {});

}  // namespace horopter::scenarios
