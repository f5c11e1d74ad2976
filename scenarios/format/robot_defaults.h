// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenarios/format/robot_description.h"
#include "scenarios/format/scenario.h"

namespace horopter::scenarios {

/// Replaces every kRobotsOwn of the scenario by what the robot has.
void FillFromRobot(const RobotDescription& robot, Scenario& scenario);

}  // namespace horopter::scenarios
