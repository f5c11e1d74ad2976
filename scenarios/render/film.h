// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hardware/types/eye.h"
#include "hardware/types/head_angles.h"
#include "hardware/types/stage_times.h"
#include "hardware/types/stereo_frame.h"
#include "hardware/types/time.h"
#include "scenarios/dataset/dataset_writer.h"
#include "scenarios/format/robot_description.h"
#include "scenarios/render/frame_truth.h"
#include "scenarios/render/head_reach.h"
#include "scenarios/render/motion.h"
#include "scenarios/render/motion_outcome.h"
#include "scenarios/render/moving_robot.h"
#include "scenarios/render/render_request.h"
#include "scenarios/render/scene_setup.h"
#include "scenarios/render/state_log.h"

namespace horopter::scenarios {

/// Plays a request's motion in lockstep, and hands out the frames that the robot's cameras deliver
/// meanwhile: those that a program with these cameras would get, latency, shutter, lost and
/// repeated frames and all. Of several pairs the first one's frames count, each with the newest
/// that the others have delivered by then.
class Film {
 public:
  /// When one pair's images were taken, and when they came; the run's clock.
  struct Capture {
    std::string pair;
    std::uint64_t sequence = 0;
    hardware::PerEye<hardware::Time> t_capture;  ///< middle of the exposure
    hardware::Duration half_readout{};           ///< first row before, last row after that
    hardware::Time t_delivered{};
  };
  struct Frame {
    /// Time, head and state are those of the first pair's left image.
    DatasetFrame content;
    std::vector<Capture> captures;
    std::string states;  ///< rows of StateLog, since the frame before
  };

  /// Takes the scenery's world, with its head already where the motion starts.
  /// @param request outlives the film; its motion has passed CheckMotion()
  /// @param start the head's angles
  /// @throws hardware::ConfigError, sim::SceneError, sim::RenderError
  Film(const RenderRequest& request, const RobotDescription& robot,
       const hardware::HeadAngles& start, Scenery& scenery);

  std::string gl_renderer() const { return robot_->gl_renderer(); }
  const mjModel& model() { return robot_->world().model(); }

  /// How many frames come when none is lost.
  int ExpectedFrames() const;

  /// Lets time pass until the next frame; nothing at the motion's end.
  std::optional<Frame> Next();

  /// What has come of the commands to legs and wheels so far.
  std::vector<CommandOutcome> Outcomes() const { return watch_.Outcomes(Base()); }

  /// Rows of StateLog that no frame has taken.
  std::string RestOfStates() { return log_.TakeRows(); }

 private:
  struct Pair {
    std::string name;
    std::string shown_as;  ///< empty where it is the only one
    hardware::PerEye<std::string> mjcf_camera;
  };

  static std::vector<Pair> PairsOf(const RenderRequest& request, const RobotDescription& robot);
  /// In the robot's starting frame.
  hardware::Pose2 Base() const;
  void GiveCommands();
  void Step();
  /// Takes what the cameras have delivered. @return whether it is a new frame
  bool Grab();
  /// The newest images as a frame, with their truth.
  Frame Develop();
  DatasetEye DevelopEye(std::size_t pair, hardware::Eye eye, FrameTruth::Scene& scene);

  const RenderRequest& request_;
  hardware::StageTimes times_;
  HeadReach reach_;
  std::vector<Pair> pairs_;
  std::vector<MotionCommand> commands_;  ///< by time
  std::size_t next_command_ = 0;
  std::optional<MotionCommand> drive_;  ///< the last DriveCommand, from when it is given on
  hardware::HeadAngles head_target_;
  std::unique_ptr<MovingRobot> robot_;
  MotionWatch watch_;
  StateLog log_;
  std::optional<FrameTruth> truth_;            ///< when it is asked for
  std::vector<hardware::StereoFrame> newest_;  ///< of each pair
  std::optional<std::uint64_t> last_;          ///< sequence of the first pair's last frame
};

}  // namespace horopter::scenarios
