// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "scenarios/results/run_record.h"

namespace horopter::scenarios {

/// Rows of frames.csv and trajectory.csv, without line ends (RFC 4180). A value that never was is
/// an empty field. Lengths in metres, times in seconds; angles carry their unit in the column name.
std::string_view FrameTableHeader();
std::string FrameTableRow(const FrameRecord& frame);
std::string_view PathTableHeader();
std::string PathTableRow(const PathPoint& point);

}  // namespace horopter::scenarios
