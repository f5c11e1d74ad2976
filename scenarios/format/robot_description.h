// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "hardware/types/base_state.h"
#include "hardware/types/head_angles.h"
#include "hardware/types/head_geometry.h"
#include "scenarios/format/diagnostics.h"

namespace horopter::scenarios {

/// What every backend of a robot shares: what the stack may know of the robot it drives. From
/// scenes/<robot>/robot.yaml. Base frame: on the ground under the driven axle.
struct RobotDescription {
  std::filesystem::path file;
  std::string name;
  std::string mjcf_base_body = "base";  ///< its root body in MuJoCo models

  hardware::BaseProperties base;
  int pulses_per_turn = 0;  ///< of a driven wheel
  double wheel_radius_m = 0;
  double max_wheel_acceleration_m_s2 = 0;
  double deadman_s = 0;  ///< without a command for this long, the base stops
  double radius_m = 0;   ///< of the circle about the base's origin that holds the body

  hardware::HeadGeometry head_geometry;
  hardware::HeadLimits head_limits;
  double head_resolution_deg = 0;  ///< one encoder position
  double camera_horizontal_fov_deg = 0;
};

/// Reads and checks a robot.yaml, as strictly as a scenario.
/// @throws ScenarioError with everything that is wrong with it
RobotDescription LoadRobotDescription(const std::filesystem::path& path);

/// The same for a text. @param name how messages name it
RobotDescription ParseRobotDescription(const std::string& text, const std::string& name);

/// JSON Schema (draft 7) of robot.yaml.
nlohmann::json RobotSchema();

}  // namespace horopter::scenarios
