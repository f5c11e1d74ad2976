// SPDX-License-Identifier: Apache-2.0
#include "scenarios/render/film.h"

#include <cmath>
#include <utility>
#include <variant>

#include "scenarios/render/request_checks.h"
#include "sim/camera/frame_timing.h"
#include "sim/camera/row_exposure.h"
#include "sim/render/renderer.h"

namespace horopter::scenarios {

using hardware::Eye;

namespace {

hardware::StereoFrame GrabFrom(hardware::CameraPair& cameras) {
  auto frame = cameras.Grab();
  if (!frame.ok()) throw sim::RenderError(frame.error().message);
  return std::move(frame).value();
}

/// From the first row's exposure to the middle of the image's.
hardware::Duration HalfReadout(const sim::CameraProfile& profile) {
  const sim::RowExposure rows(profile.shutter, profile.exposure, 2);
  return hardware::FromSeconds((rows.Middle(1) - rows.Middle(0)) / 2);
}

}  // namespace

Film::Film(const RenderRequest& request, const RobotDescription& robot,
           const hardware::HeadAngles& start, Scenery& scenery)
    : request_(request),
      reach_(robot),
      pairs_(PairsOf(request, robot)),
      commands_(InOrder(request.motion.value())),
      head_target_(start),
      robot_(MakeMovingRobot(request, robot, std::move(scenery.world), scenery.X_WO, times_)),
      log_(robot_->X_WO()),
      newest_(pairs_.size()) {
  if (request.truth) truth_.emplace(request, model());
  log_.Record(robot_->clock().Now(), robot_->world());
  robot_->OnStep([this](const sim::World& world) { log_.Record(robot_->clock().Now(), world); });
}

std::vector<Film::Pair> Film::PairsOf(const RenderRequest& request, const RobotDescription& robot) {
  std::vector<Pair> pairs;
  const auto names = PairNames(request, robot);
  for (const std::string& name : names) {
    const CameraPairDescription& pair = robot.Cameras(name);
    pairs.push_back({name, names.size() > 1 ? name : "", {pair.left, pair.right}});
  }
  return pairs;
}

int Film::ExpectedFrames() const {
  const sim::CameraProfile& profile = request_.camera.profile;
  sim::TimingProfile regular;
  regular.rate_hz = profile.timing.rate_hz;
  regular.latency_s = profile.timing.latency_s;
  regular.skew_s = profile.timing.skew_s;
  const hardware::Duration step = robot_->world().step();
  const double window_s = sim::RowExposure(profile.shutter, profile.exposure, 2).window_s();
  const sim::FrameTiming timing(regular, hardware::FromSeconds(window_s), step, 0, "");
  const auto end = hardware::FromSeconds(request_.motion->duration_s);
  const hardware::Time last_look{(end - hardware::Duration(1)) / step * step};
  return static_cast<int>(timing.NewestDelivered(last_look)) + 1;
}

std::optional<Film::Frame> Film::Next() {
  const hardware::Time end{hardware::FromSeconds(request_.motion->duration_s)};
  while (robot_->clock().Now() < end) {
    GiveCommands();
    const bool is_new = Grab();
    std::optional<Frame> frame;
    if (is_new) frame = Develop();
    Step();
    if (frame) return frame;
  }
  return std::nullopt;
}

hardware::Pose2 Film::Base() const {
  const hardware::Pose X_OB = robot_->X_WO().inverse() * robot_->world().X_WBody("base");
  const auto& R = X_OB.linear();
  return {X_OB.translation().x(), X_OB.translation().y(), std::atan2(R(1, 0), R(0, 0))};
}

void Film::GiveCommands() {
  const double now_s = hardware::ToSeconds(robot_->clock().Now());
  for (; next_command_ < commands_.size() && commands_[next_command_].at_s <= now_s;
       ++next_command_) {
    const MotionCommand& command = commands_[next_command_];
    watch_.Told(command, Base());
    if (const auto* saccade = std::get_if<SaccadeCommand>(&command.what)) {
      head_target_ = AnglesOf(*saccade, head_target_, reach_, "");
      const auto done = robot_->head().Command(head_target_);
      if (!done.ok()) throw sim::PhysicsError(done.error().message);
    } else if (std::holds_alternative<DriveCommand>(command.what)) {
      drive_ = command;
    } else {
      robot_->Give(command);
    }
  }
  if (drive_) robot_->Give(*drive_);
}

void Film::Step() {
  hardware::Clock& clock = robot_->clock();
  clock.SleepUntil(clock.Now() + robot_->world().step());
  watch_.Step(hardware::ToSeconds(clock.Now()), Base());
}

bool Film::Grab() {
  newest_[0] = GrabFrom(robot_->cameras(pairs_[0].name));
  if (last_ && newest_[0].sequence == *last_) return false;
  last_ = newest_[0].sequence;
  for (std::size_t i = 1; i < pairs_.size(); ++i)
    newest_[i] = GrabFrom(robot_->cameras(pairs_[i].name));
  return true;
}

Film::Frame Film::Develop() {
  Frame frame;
  std::vector<hardware::PerEye<FrameTruth::Scene>> scenes(pairs_.size());
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const hardware::StereoFrame& seen = newest_[i];
    frame.captures.push_back({pairs_[i].name,
                              seen.sequence,
                              {seen.left.t_capture, seen.right.t_capture},
                              HalfReadout(request_.camera.profile),
                              seen.t_delivered});
    frame.content.pairs.push_back({pairs_[i].shown_as, DevelopEye(i, Eye::kLeft, scenes[i].left),
                                   DevelopEye(i, Eye::kRight, scenes[i].right)});
  }
  frame.content.t = newest_[0].left.t_capture;
  log_.ForgetBefore(frame.content.t);
  frame.content.state = log_.At(frame.content.t);
  frame.content.head = HeadIn(*frame.content.state).angles;
  frame.states = log_.TakeRows();
  if (truth_) truth_->Add(scenes, frame.content);
  return frame;
}

DatasetEye Film::DevelopEye(std::size_t pair, Eye eye, FrameTruth::Scene& scene) {
  const Pair& named = pairs_[pair];
  sim::EyeView view{hardware::Pose::Identity(), robot_->cameras(named.name).model(eye)};
  robot_->AtCapture(named.name, eye, [&] {
    view.X_WC = robot_->world().X_WCamera(named.mjcf_camera[eye]);
    if (truth_) scene = truth_->SceneOf(robot_->world().data());
  });
  return {view, newest_[pair][eye].bgr, {}, {}, {}};
}

}  // namespace horopter::scenarios
