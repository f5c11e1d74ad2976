// SPDX-License-Identifier: Apache-2.0
#include "scenarios/runner/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <utility>

#include "control/base/unicycle.h"
#include "scenarios/format/diagnostics.h"
#include "scenarios/results/frame_pictures.h"
#include "scenarios/runner/stack_config.h"

namespace horopter::scenarios {
namespace {

using hardware::Duration;
using hardware::FromSeconds;
using hardware::Result;
using hardware::Time;
using hardware::ToSeconds;

constexpr Duration kControlPeriod = std::chrono::milliseconds(20);
constexpr int kTicksPerPathPoint = 5;
constexpr Duration kPicturePeriod = std::chrono::seconds(2);

/// What a settled axis may miss its command by: the servo's error, and so many encoder steps.
constexpr double kServoErrorDeg = 0.05;
constexpr double kSettledSteps = 2.5;

template <typename T>
T Demand(Result<T> result, const char* what) {
  if (!result.ok()) throw DeviceFailure(what, result.error());
  return std::move(result).value();
}

void Demand(const Result<void>& result, const char* what) {
  if (!result.ok()) throw DeviceFailure(what, result.error());
}

hardware::PerEye<hardware::CameraModel> Models(const hardware::CameraPair& cameras) {
  return {cameras.model(hardware::Eye::kLeft), cameras.model(hardware::Eye::kRight)};
}

BehaviourContext ContextOf(const Scenario& scenario, const RobotDescription& robot) {
  constexpr double kRadians = M_PI / 180;
  const double encoder_deg = scenario.head.encoder_step_deg + scenario.head.encoder_noise_deg;
  return {robot.head_geometry, robot.head_limits,
          (kServoErrorDeg + kSettledSteps * encoder_deg) * kRadians};
}

int PlannedGotos(const Scenario& scenario) {
  return static_cast<int>(std::count_if(
      scenario.steps.begin(), scenario.steps.end(),
      [](const Step& step) { return std::holds_alternative<GotoStep>(step.action); }));
}

/// Devices that are active as long as this lives: whatever ends a run, they are stopped.
class ActiveDevices {
 public:
  explicit ActiveDevices(Backend& backend)
      : devices_{&backend.base(), &backend.head(), &backend.cameras()} {
    for (hardware::Device* device : devices_) {
      Demand(device->Configure(), "configuring");
      Demand(device->Activate(), "activating");
    }
  }
  ~ActiveDevices() {
    for (hardware::Device* device : devices_) device->Deactivate();
  }
  ActiveDevices(const ActiveDevices&) = delete;
  ActiveDevices& operator=(const ActiveDevices&) = delete;

 private:
  hardware::Device* devices_[3];
};

}  // namespace

Session::Session(const Scenario& scenario, const RobotDescription& robot, Backend& backend,
                 RunWriter& writer, hardware::StageTimes& times, RunHooks hooks)
    : scenario_(scenario),
      robot_(robot),
      backend_(backend),
      writer_(writer),
      times_(times),
      hooks_(std::move(hooks)),
      vision_(scenario.vision, Models(backend.cameras()), robot),
      odometry_(backend.base().properties()),
      navigator_(NavigatorConfigOf(scenario, robot)),
      context_(ContextOf(scenario, robot)),
      book_(PlannedGotos(scenario)) {
  if (TruthProbe* truth = backend_.truth()) plan_ = truth->Plan();
  plan_.robot_radius_m = robot.radius_m;
}

Session::Ending Session::Run() {
  const ActiveDevices active(backend_);
  Ending ending;
  for (const Step& step : scenario_.steps) {
    ending = Play(step);
    if (ending.interrupted || !ending.failure.empty()) break;
  }
  return ending;
}

bool Session::OutOfTime() const { return ToSeconds(next_tick_) > scenario_.time_limit_s; }

Session::Ending Session::Play(const Step& step) {
  const StepAction& action = step.action;
  const std::string name = StepName(action);
  const std::string out_of_time =
      fmt::format("the scenario's time limit of {:g} s has passed", scenario_.time_limit_s);
  if (OutOfTime()) return {false, fmt::format("{} before {}", out_of_time, name)};
  const auto behaviour = MakeBehaviour(action, context_, navigator_);
  const Time begun = next_tick_;
  Ending ending;
  StepOutput output;
  do {
    output = Tick(*behaviour, name);
    ending.interrupted = hooks_.interrupted();
  } while (!output.done && !ending.interrupted && !OutOfTime());
  if (const auto* go = std::get_if<GotoStep>(&action)) FinishGoto(*go, output, begun);
  if (output.impossible) {
    Fail(step.mark,
         fmt::format("{}: {}, where the robot is by then; give another target, or a goto "
                     "before that brings it into reach",
                     name, output.failure));
  }
  if (!output.failure.empty()) {
    ending.failure = name + ": " + output.failure;
  } else if (!output.done && !ending.interrupted) {
    ending.failure = fmt::format("{} during {}", out_of_time, name);
  }
  return ending;
}

StepOutput Session::Tick(Behaviour& behaviour, const std::string& step_name) {
  backend_.clock().SleepUntil(next_tick_);
  const StackState state = Read();
  Deliver(state);
  if (state.t >= next_view_ && !pending_) See(state, step_name);
  const StepOutput output =
      times_.Measure("navigation, a tick", [&] { return behaviour.Update(state); });
  Write(output);
  Record(state, output);
  next_tick_ += kControlPeriod;
  hooks_.progress(ToSeconds(state.t), step_name);
  return output;
}

StackState Session::Read() {
  StackState state;
  state.t = backend_.clock().Now();
  const hardware::BaseState base = Demand(backend_.base().Read(), "reading the base");
  state.X_OB = odometry_.Update(base);
  const hardware::HeadReading head = Demand(backend_.head().Read(), "reading the head");
  angles_.Add(head);
  state.angles = head.angles;
  return state;
}

StackState Session::AtCapture(const hardware::StereoFrame& frame, const StackState& now) const {
  StackState then;
  then.t = frame.left.t_capture;
  then.X_OB = odometry_.PoseAt(then.t).value_or(now.X_OB);
  then.angles = angles_.At(then.t);
  then.angles.right = angles_.At(frame.right.t_capture).right;
  return then;
}

void Session::See(const StackState& state, const std::string& step_name) {
  next_view_ = state.t + FromSeconds(1 / scenario_.vision.rate_hz);
  const hardware::StereoFrame frame = Demand(backend_.cameras().Grab(), "grabbing a frame");
  image_hash_.Update(frame.left.bgr);
  image_hash_.Update(frame.right.bgr);
  const StackState then = AtCapture(frame, state);
  VisionResult result =
      times_.Measure(kCycleStage, [&] { return vision_.Run(frame, then.angles, times_); });

  FrameRecord record;
  record.index = frames_;
  record.t_capture = then.t;
  record.odometry = then.X_OB;
  record.angles = then.angles;
  record.step = step_name;
  record.decision = last_decision_;
  record.disparity_density = cv::countNonZero(result.disparity.valid) /
                             static_cast<double>(result.disparity.valid.total());
  record.regions = static_cast<int>(result.regions.regions.size());
  FrameTruth truth;
  if (TruthProbe* probe = backend_.truth()) {
    truth = probe->AtCapture();
    record.true_pose = probe->X_OB();
    record.clearance_m = probe->Clearance();
    if (fixated_O_) record.fixation_error_deg = probe->FixationErrorDeg(*fixated_O_);
    record.depth = book_.AddFrame(result.depth_m, truth, fixated_O_.has_value());
  }
  const bool picture =
      frames_ == 0 || fixated_O_ || record.t_capture - last_picture_ >= kPicturePeriod;
  if (picture) {
    last_picture_ = record.t_capture;
    writer_.AddFrame(record, MakeFrameImages(frame, result.disparity, result.depth_m, truth.depth_m,
                                             result.regions));
  } else {
    writer_.AddFrame(record);
  }
  ++frames_;
  pending_ = Pending{control::MakeSceneView(result.t_capture, std::move(result.regions),
                                            std::move(result.points_B)),
                     then.X_OB, state.t + FromSeconds(scenario_.vision.latency_s)};
}

void Session::Deliver(const StackState& state) {
  if (!pending_ || state.t < pending_->due) return;
  times_.Measure("navigation, a view",
                 [&] { navigator_.OnView(pending_->view, pending_->X_OB_at_capture); });
  pending_.reset();
}

void Session::Write(const StepOutput& output) {
  Demand(backend_.base().Command(control::FromTwist(output.twist, backend_.base().properties())),
         "commanding the base");
  if (output.head) Demand(backend_.head().Command(*output.head), "commanding the head");
}

void Session::Record(const StackState& state, const StepOutput& output) {
  decision_hash_.Update(output.decision);
  decision_hash_.Update(output.twist.forward_m_s);
  decision_hash_.Update(output.twist.turn_rad_s);
  if (output.head) {
    for (const double angle : hardware::ToArray(*output.head)) decision_hash_.Update(angle);
  }
  last_decision_ = output.decision;
  fixated_O_ = output.fixated_O;

  ScoreBook::Tick tick;
  tick.odometry = state.X_OB;
  if (TruthProbe* truth = backend_.truth()) {
    tick.true_pose = truth->X_OB();
    tick.clearance_m = truth->Clearance();
    tick.contacts = truth->contacts();
    if (output.fixated_O) tick.fixation_error_deg = truth->FixationErrorDeg(*output.fixated_O);
  }
  book_.AddTick(tick);
  if (ticks_++ % kTicksPerPathPoint == 0) {
    const PathPoint point{ToSeconds(state.t), state.X_OB, tick.true_pose};
    writer_.AddPathPoint(point);
    plan_.path.push_back(point);
  }
  if (output.waypoint_O) {
    const std::pair waypoint(output.waypoint_O->x_m, output.waypoint_O->y_m);
    if (plan_.waypoints_m.empty() || plan_.waypoints_m.back() != waypoint) {
      plan_.waypoints_m.push_back(waypoint);
    }
  }
}

void Session::FinishGoto(const GotoStep& step, const StepOutput& last, Time begun) {
  plan_.goals_m.emplace_back(step.goal_m.x(), step.goal_m.y());
  GotoOutcome outcome;
  outcome.reached = last.done && last.failure.empty();
  outcome.duration_s = ToSeconds(next_tick_ - begun);
  if (TruthProbe* truth = backend_.truth()) {
    const hardware::Pose2 X_OB = truth->X_OB();
    outcome.true_distance_m = std::hypot(X_OB.x_m - step.goal_m.x(), X_OB.y_m - step.goal_m.y());
  }
  book_.AddGoto(outcome);
}

}  // namespace horopter::scenarios
