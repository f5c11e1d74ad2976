// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "control/navigator/navigator_config.h"
#include "control/navigator/obstacle_points.h"
#include "scenarios/format/robot_description.h"
#include "scenarios/format/scenario.h"

namespace horopter::scenarios {

/// What the navigator goes by: its defaults, with what scenario and robot say otherwise.
control::NavigatorConfig NavigatorConfigOf(const Scenario& scenario, const RobotDescription& robot);

/// What could be hit by this robot.
control::ObstacleConfig ObstacleConfigOf(const RobotDescription& robot);

/// The numbers that the stack runs with, as JSON: those of the robot's file and the defaults of
/// navigator, obstacle test, reconstruction, segmentation and regions, which the resolved scenario
/// does not hold. Two runs of one scenario with one record ran the same stack. Of the disparity
/// method it has the name, preset and scales; the preset's own numbers are the build's.
inline constexpr const char* kStackRecordFile = "stack.json";  ///< in the run's folder
std::string StackRecord(const Scenario& scenario, const RobotDescription& robot);

}  // namespace horopter::scenarios
