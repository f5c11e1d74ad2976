// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>

#include "control/base/odometry.h"
#include "control/kinematics/angle_history.h"
#include "control/navigator/navigator.h"
#include "hardware/types/result.h"
#include "hardware/types/stage_times.h"
#include "scenarios/format/robot_description.h"
#include "scenarios/format/scenario.h"
#include "scenarios/results/hasher.h"
#include "scenarios/results/run_writer.h"
#include "scenarios/runner/backend.h"
#include "scenarios/runner/behaviour.h"
#include "scenarios/runner/score_book.h"
#include "scenarios/runner/vision_cycle.h"

namespace horopter::scenarios {

/// Stage that the whole of a vision cycle is booked under: what VisionSpec::latency_s models.
inline constexpr char kCycleStage[] = "vision, a cycle";

/// What the runner is told and asked while a run goes on.
struct RunHooks {
  /// Simulated seconds so far, and what is being done.
  std::function<void(double sim_s, const std::string& doing)> progress = [](double,
                                                                            const std::string&) {};
  /// True: stop at the next tick; the run ends incomplete.
  std::function<bool()> interrupted = [] { return false; };
};

/// Plays the steps of one scenario on one backend, in lockstep: read, update, write, every 20 ms of
/// the backend's clock, with a vision cycle whenever one is due.
class Session {
 public:
  /// @throws hardware::ConfigError
  Session(const Scenario& scenario, const RobotDescription& robot, Backend& backend,
          RunWriter& writer, hardware::StageTimes& times, RunHooks hooks);

  /// How it ended.
  struct Ending {
    bool interrupted = false;
    std::string failure;  ///< of the step that gave up; the steps after it were not begun
  };

  /// @throws DeviceFailure when a device refuses what it must not
  /// @throws ScenarioError when a step asks for a gaze that is impossible from where the robot is
  Ending Run();

  const ScoreBook& book() const { return book_; }
  std::string image_hash() const { return image_hash_.Hex(); }
  std::string decision_hash() const { return decision_hash_.Hex(); }
  const PlanRecord& plan() const { return plan_; }

 private:
  /// A vision result on its way to the stack: its modelled latency has not passed yet.
  struct Pending {
    control::SceneView view;
    hardware::Pose2 X_OB_at_capture;
    hardware::Time due{};
  };

  bool OutOfTime() const;
  Ending Play(const Step& step);
  StepOutput Tick(Behaviour& behaviour, const std::string& step_name);
  StackState Read();
  void See(const StackState& state, const std::string& step_name);
  /// Where base and head were when a frame was taken, each eye at its own instant.
  StackState AtCapture(const hardware::StereoFrame& frame, const StackState& now) const;
  void Deliver(const StackState& state);
  void Write(const StepOutput& output);
  void Record(const StackState& state, const StepOutput& output);
  void FinishGoto(const GotoStep& step, const StepOutput& last, hardware::Time begun);

  const Scenario& scenario_;
  const RobotDescription& robot_;
  Backend& backend_;
  RunWriter& writer_;
  hardware::StageTimes& times_;
  RunHooks hooks_;

  VisionCycle vision_;
  control::Odometry odometry_;
  control::AngleHistory angles_;
  control::Navigator navigator_;
  BehaviourContext context_;
  ScoreBook book_;
  Hasher image_hash_;
  Hasher decision_hash_;
  PlanRecord plan_;

  hardware::Time next_tick_{};
  hardware::Time next_view_{};
  hardware::Time last_picture_{};
  std::uint64_t frames_ = 0;
  std::uint64_t ticks_ = 0;
  std::optional<Pending> pending_;
  std::string last_decision_;
  std::optional<Eigen::Vector3d> fixated_O_;  ///< where both axes met at the last tick
};

/// A device refused or failed in the middle of a run.
class DeviceFailure : public std::runtime_error {
 public:
  /// @param what was being done
  DeviceFailure(const std::string& what, const hardware::Error& error)
      : std::runtime_error(what + ": " + error.message), code_(error.code) {}

  hardware::ErrorCode code() const { return code_; }

 private:
  hardware::ErrorCode code_;
};

}  // namespace horopter::scenarios
