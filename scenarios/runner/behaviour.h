// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>

#include "control/navigator/navigator.h"
#include "hardware/interfaces/stereo_head.h"
#include "hardware/types/head_angles.h"
#include "hardware/types/head_geometry.h"
#include "hardware/types/pose.h"
#include "hardware/types/time.h"
#include "scenarios/format/scenario.h"

namespace horopter::scenarios {

/// What the stack knows at one tick. O is the robot's starting frame, B the base.
struct StackState {
  hardware::Time t{};
  hardware::Pose2 X_OB;         ///< odometry
  hardware::HeadAngles angles;  ///< as read
};

/// What a step wants done at one tick.
struct StepOutput {
  hardware::Twist2 twist;
  std::optional<hardware::HeadAngles> head;  ///< nothing: stay
  bool done = false;
  std::string failure;      ///< why the step gave up; empty when it did not
  bool impossible = false;  ///< it gave up on what the scenario should not have asked for
  std::string decision;     ///< one line for the log
  std::optional<Eigen::Vector3d> fixated_O;  ///< both axes should meet here now: to be scored
  std::optional<hardware::Pose2> waypoint_O;
};

/// One step of a scenario under way: from the first Update() until `done`.
class Behaviour {
 public:
  virtual ~Behaviour() = default;
  virtual StepOutput Update(const StackState& state) = 0;
};

/// What steps need besides the state.
struct BehaviourContext {
  hardware::HeadGeometry geometry;
  hardware::HeadLimits limits;
  double settled_rad = 0;  ///< an axis this close to its command has arrived
};

/// @param navigator lives through all steps, so that obstacles are remembered; goto steps drive it
std::unique_ptr<Behaviour> MakeBehaviour(const StepAction& action, const BehaviourContext& context,
                                         control::Navigator& navigator);

/// "goto", "fixate", ...
std::string StepName(const StepAction& action);

}  // namespace horopter::scenarios
