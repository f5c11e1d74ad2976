// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "hardware/types/head_angles.h"
#include "scenarios/format/field_visitor.h"
#include "scenarios/format/robot_description.h"
#include "scenarios/render/head_reach.h"

namespace horopter::scenarios {

/// The head turns, as fast as its axes can: to a gaze, or to angles of axes. Signs as in Gaze and
/// hardware::HeadAngles; what is left out stays as it was told last, or as the motion began.
struct SaccadeCommand {
  static constexpr std::array<const char*, 3> kGazeKeys = {"pan_deg", "tilt_deg", "vergence_deg"};

  std::array<std::optional<double>, 3> gaze_deg;  ///< in the order of kGazeKeys
  /// In the order of hardware::kHeadAxisNames.
  std::array<std::optional<double>, hardware::kHeadAxisCount> axis_deg;

  bool operator==(const SaccadeCommand&) const = default;
};

/// A humanoid walks to a pose and stands there: forward and left of where it stands when it is
/// told, and how far it turns left.
struct WalkToCommand {
  double x_m = 0;
  double y_m = 0;
  double turn_deg = 0;

  bool operator==(const WalkToCommand&) const = default;
};

/// A humanoid walks at a velocity until told otherwise; all zero: it stops.
struct WalkCommand {
  double forward_m_s = 0;
  double left_m_s = 0;
  double turn_deg_s = 0;

  bool operator==(const WalkCommand&) const = default;
};

/// A base on wheels drives at a speed until told otherwise; both zero: it stops.
struct DriveCommand {
  double forward_m_s = 0;
  double turn_deg_s = 0;  ///< to the left

  bool operator==(const DriveCommand&) const = default;
};

/// One command of a motion, and when it is given.
struct MotionCommand {
  double at_s = 0;
  std::variant<SaccadeCommand, WalkToCommand, WalkCommand, DriveCommand> what;

  bool operator==(const MotionCommand&) const = default;
};

/// What a robot is told to do while its cameras run. Commands of one instant are given in the order
/// of the list.
struct Motion {
  double duration_s = 1;  ///< frames that are delivered until then
  std::vector<MotionCommand> commands;

  bool operator==(const Motion&) const = default;
};

/// The fields of a motion's file.
void Visit(FieldVisitor& v, Motion& motion);

/// Reads a YAML file of a motion, as strictly as a scenario.
/// @throws ScenarioError with everything that is wrong with it, or that it cannot be read
Motion ReadMotionFile(const std::filesystem::path& path);

/// The motion's commands by time; those of one instant as they stand.
std::vector<MotionCommand> InOrder(const Motion& motion);

/// The angles that a saccade leads to.
/// @param present the angles that the head was told before
/// @param where heads messages
/// @throws hardware::ConfigError when it mixes gaze and axes, or the head does not turn so far
hardware::HeadAngles AnglesOf(const SaccadeCommand& saccade, const hardware::HeadAngles& present,
                              const HeadReach& reach, const std::string& where);

/// Holds a motion against the robot, before anything is loaded.
/// @param start the head's angles at the beginning
/// @throws hardware::ConfigError naming every command that the robot cannot follow, or that comes
///         after the end
void CheckMotion(const Motion& motion, const RobotDescription& robot,
                 const hardware::HeadAngles& start = {});

}  // namespace horopter::scenarios
