// SPDX-License-Identifier: Apache-2.0
#include "scenarios/format/robot_defaults.h"

namespace horopter::scenarios {

void FillFromRobot(const RobotDescription& robot, Scenario& scenario) {
  if (scenario.camera.horizontal_fov_deg == kRobotsOwn) {
    scenario.camera.horizontal_fov_deg = robot.Cameras("").horizontal_fov_deg;
  }
  if (scenario.head.encoder_step_deg == kRobotsOwn) {
    scenario.head.encoder_step_deg = robot.encoder_step_deg;
  }
}

}  // namespace horopter::scenarios
