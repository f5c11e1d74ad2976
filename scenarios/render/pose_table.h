// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "hardware/types/head_angles.h"
#include "scenarios/format/body_placement.h"
#include "scenarios/render/head_reach.h"

namespace horopter::scenarios {

/// Where the head looks and where movable bodies are, a view per row. Columns, in any order:
///
///   pan_deg tilt_deg vergence_deg   a gaze (Gaze); what is left out is 0
///   neck_pan_deg ... right_tilt_deg axes by hardware::kHeadAxisNames, in place of a gaze; likewise
///   NAME.x_m NAME.y_m NAME.z_m NAME.yaw_deg NAME.pitch_deg NAME.roll_deg
///                                   a body of the scene (BodyPlacement); the three lengths are
///                                   needed, angles left out are 0
struct PoseTable {
  std::string file;  ///< that it came from, for messages; empty: from options
  std::vector<std::string> columns;
  std::vector<std::vector<double>> rows;  ///< as long as `columns` each
};

/// One row of it.
struct PosedView {
  hardware::HeadAngles head;
  std::map<std::string, BodyPlacement> bodies;
};

/// A CSV table whose header names the columns.
/// @param name of the file, for messages
/// @throws FormatError naming file, line and field; also when there is no row
PoseTable DecodePoseTable(std::string_view text, const std::string& name);

/// What the rows say.
/// @throws hardware::ConfigError naming the column that is not known, stands twice, or lacks
///         another; or the row whose angles are beyond the head's reach
std::vector<PosedView> ViewsOf(const PoseTable& table, const HeadReach& reach);

}  // namespace horopter::scenarios
