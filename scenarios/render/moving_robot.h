// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "hardware/interfaces/camera_pair.h"
#include "hardware/interfaces/clock.h"
#include "hardware/interfaces/stereo_head.h"
#include "hardware/types/eye.h"
#include "hardware/types/pose.h"
#include "hardware/types/stage_times.h"
#include "scenarios/format/robot_description.h"
#include "scenarios/render/motion.h"
#include "scenarios/render/render_request.h"
#include "sim/world/world.h"

namespace horopter::scenarios {

/// A simulated robot that a motion moves, whichever robot it is. All devices are active. The
/// request's faults are at work in it: its eyes stand where they put them, for truth too; frozen
/// frames and a swapped pair change the images alone.
class MovingRobot {
 public:
  virtual ~MovingRobot() = default;

  virtual hardware::Clock& clock() = 0;
  virtual hardware::StereoHead& head() = 0;
  /// @param pair by its name in the robot's description
  /// @throws std::invalid_argument when a robot of several pairs has none of that name
  virtual hardware::CameraPair& cameras(const std::string& pair) = 0;
  virtual std::string gl_renderer() const = 0;

  /// For truth.
  virtual sim::World& world() = 0;
  virtual hardware::Pose X_WO() const = 0;
  /// Runs `look` with the world as it was when an eye's newest image was taken.
  virtual void AtCapture(const std::string& pair, hardware::Eye eye,
                         const std::function<void()>& look) = 0;
  /// Called after every physics step.
  virtual void OnStep(std::function<void(const sim::World&)> observer) = 0;

  /// Gives a command for legs or wheels; a DriveCommand again at every step, since a base whose
  /// commands cease stops. @pre CheckMotion() has passed the command
  /// @throws sim::PhysicsError when the robot cannot: it has fallen
  virtual void Give(const MotionCommand& command) = 0;
};

/// The robot of the request in a furnished world, its head at rest where its joints are.
/// @param X_WO the robot's starting frame, where the robot does not settle first
/// @param times outlives the robot
/// @throws hardware::ConfigError when there is no simulation of such a robot; sim::SceneError,
///         sim::RenderError
std::unique_ptr<MovingRobot> MakeMovingRobot(const RenderRequest& request,
                                             const RobotDescription& robot,
                                             std::unique_ptr<sim::World> world,
                                             const hardware::Pose& X_WO,
                                             hardware::StageTimes& times);

}  // namespace horopter::scenarios
