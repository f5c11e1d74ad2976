// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "hardware/types/base_state.h"
#include "hardware/types/camera_model.h"
#include "hardware/types/head_angles.h"
#include "hardware/types/head_geometry.h"
#include "scenarios/format/diagnostics.h"

namespace horopter::scenarios {

/// A base with two driven sides.
struct WheelsDescription {
  hardware::BaseProperties properties;
  int pulses_per_turn = 0;  ///< of a driven wheel
  double max_acceleration_m_s2 = 0;
  double deadman_s = 0;  ///< without a command for this long, the base stops
};

/// Two cameras that look the same way. Each is named as in the robot's MuJoCo model.
struct CameraPairDescription {
  std::string left;
  std::string right;
  int width_px = 0;  ///< native size
  int height_px = 0;
  double horizontal_fov_deg = 0;
  /// Where the pair's optical centres are, from those of the head's geometry: up along the eyes'
  /// pan axes, ahead along the optical axes.
  double above_m = 0;
  double ahead_m = 0;

  /// Of either camera, in its native size. @throws hardware::ConfigError
  hardware::CameraModel Model() const;
};

/// What every backend of a robot shares: what the stack may know of the robot it drives. From
/// scenes/<robot>/robot.yaml. Base frame: on the ground under the robot's middle.
struct RobotDescription {
  std::filesystem::path file;
  std::string name;
  double radius_m = 0;  ///< of the circle about the base's origin that holds the body
  double height_m = 0;  ///< above the ground, head included

  std::optional<WheelsDescription> wheels;  ///< none: it does not roll

  hardware::HeadGeometry head_geometry;
  hardware::HeadLimits head_limits{};
  double encoder_step_deg = 0;  ///< of each axis of the head; 0: continuous

  std::map<std::string, CameraPairDescription> cameras;  ///< by the pair's name; at least one

  /// The pair of that name; with "" the only one, or the one named "eyes".
  /// @throws hardware::ConfigError listing the names there are
  const CameraPairDescription& Cameras(const std::string& pair) const;

  /// The head's geometry with a pair's optical centres in it. @throws hardware::ConfigError
  hardware::HeadGeometry GeometryOf(const CameraPairDescription& pair) const;
};

/// Reads and checks a robot.yaml, as strictly as a scenario.
/// @throws ScenarioError with everything that is wrong with it
RobotDescription LoadRobotDescription(const std::filesystem::path& path);

/// The same for a text. @param name how messages name it
RobotDescription ParseRobotDescription(const std::string& text, const std::string& name);

/// JSON Schema (draft 7) of robot.yaml.
nlohmann::json RobotSchema();

}  // namespace horopter::scenarios
