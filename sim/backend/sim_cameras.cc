// SPDX-License-Identifier: Apache-2.0
#include "sim/backend/sim_cameras.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace horopter::sim {
namespace {

using hardware::Duration;
using hardware::Eye;
using hardware::EyeImage;
using hardware::FromSeconds;
using hardware::PerEye;
using hardware::StereoFrame;
using hardware::Time;

/// Rounded up to whole steps.
Duration WholeSteps(Duration d, Duration step) { return (d + step - Duration(1)) / step * step; }

/// How far back the captures of a frame of now lie: the later eye's image has just been delivered.
PerEye<Duration> Lags(const TimingProfile& timing, Duration half_window, Duration step) {
  const Duration newest = WholeSteps(half_window + FromSeconds(timing.latency_s), step);
  const Duration skew = WholeSteps(FromSeconds(std::abs(timing.skew_s)), step);
  return timing.skew_s > 0 ? PerEye<Duration>{newest + skew, newest}
                           : PerEye<Duration>{newest, newest + skew};
}

EyeImage Copy(const EyeImage& image) { return {image.bgr.clone(), image.t_capture}; }

}  // namespace

cv::Size SimCamerasConfig::RenderSize() const {
  cv::Size size;
  for (const Eye eye : hardware::kBothEyes) {
    const cv::Size one = EyeCamera(model[eye], profile, seed, mjcf_camera[eye]).largest_view();
    size = {std::max(size.width, one.width), std::max(size.height, one.height)};
  }
  return size;
}

SimCameras::SimCameras(World& world, Renderer& renderer, SimClock& clock,
                       const SimCamerasConfig& config, hardware::StageTimes& times)
    : config_(config),
      world_(world),
      renderer_(renderer),
      clock_(clock),
      times_(times),
      history_(world, config.mjcf_camera),
      faults_(config.faults, config.seed) {
  for (const Eye eye : hardware::kBothEyes) {
    eye_[eye].emplace(config.model[eye], config.profile, config.seed, config.mjcf_camera[eye]);
  }
  const Duration window = FromSeconds(eye_.left->exposure().window_s());
  half_window_ = window / 2;
  const TimingProfile& timing = config.profile.timing;
  lag_ = Lags(timing, half_window_, clock.step());
  if (timing.rate_hz > 0) {
    timing_.emplace(timing, window, clock.step(), config.seed, config.mjcf_camera.left);
  }
  const bool shows_the_past = timing_ || std::max(lag_.left, lag_.right).count() > 0;
  if (!shows_the_past) return;
  history_.Record(clock_.Now(), true);
  clock_.AfterStep([this] { Remember(); });
}

void SimCameras::Remember() {
  const Time now = clock_.Now();
  if (!timing_) {
    history_.Record(now, true);
    history_.ForgetBefore(now - std::max(lag_.left, lag_.right) - half_window_);
    return;
  }
  const bool captured = CapturedNow(now);
  history_.Record(now, captured);
  if (!captured) return;
  const std::uint64_t newest = timing_->NewestDelivered(now);
  Time oldest = now;
  for (const Eye eye : hardware::kBothEyes) {
    oldest = std::min(oldest, timing_->At(ShownBy(eye, newest)).t_capture[eye]);
  }
  history_.ForgetBefore(oldest - half_window_);
}

bool SimCameras::CapturedNow(Time now) {
  bool captured = false;
  for (std::uint64_t frame = next_captured_;; ++frame) {
    const FrameTimes times = timing_->At(frame);
    const auto [first, last] = std::minmax(times.t_capture.left, times.t_capture.right);
    if (first > now) return captured;
    const bool is_seen = !times.dropped && !times.repeated;
    captured = captured || (is_seen && (first == now || last == now));
    if (last <= now && frame == next_captured_) ++next_captured_;
  }
}

SimCameras::Plan SimCameras::PlanFrame() {
  const Time now = clock_.Now();
  Plan plan;
  if (!timing_) {
    plan.sequence = sequence_++;
    plan.noise = {plan.sequence, plan.sequence};
    plan.t_capture = {now - lag_.left, now - lag_.right};
    plan.t_delivered = now;
    return plan;
  }
  plan.sequence = timing_->NewestDelivered(now);
  for (const Eye eye : hardware::kBothEyes) {
    plan.noise[eye] = ShownBy(eye, plan.sequence);
    plan.t_capture[eye] = timing_->At(plan.noise[eye]).t_capture[eye];
  }
  plan.t_delivered = timing_->At(plan.sequence).t_delivered;
  return plan;
}

std::uint64_t SimCameras::ShownBy(Eye eye, std::uint64_t frame) const {
  const auto arrives = [&](std::uint64_t n) {
    const FrameTimes times = timing_->At(n);
    return !times.dropped && !faults_.Loses(eye, n, times.t_capture[eye]);
  };
  while (frame > 0 && !arrives(frame)) --frame;
  return timing_->ShownBy(frame);
}

bool SimCameras::HasSeen(Eye eye, const Plan& plan) const {
  if (!last_[eye]) return false;
  if (timing_) return last_noise_[eye] == plan.noise[eye];
  return faults_.Loses(eye, plan.sequence, plan.t_capture[eye]);
}

hardware::Result<StereoFrame> SimCameras::Grab() {
  if (const auto allowed = Require("Grab", false); !allowed.ok()) return allowed.error();
  const Plan plan = PlanFrame();
  StereoFrame frame;
  frame.sequence = plan.sequence;
  frame.t_delivered = plan.t_delivered;
  const bool repeats = timing_ || !config_.faults.empty();
  for (const Eye eye : hardware::kBothEyes) {
    EyeImage& image = eye == Eye::kLeft ? frame.left : frame.right;
    if (HasSeen(eye, plan)) {
      image = Copy(*last_[eye]);
      continue;
    }
    image = See(eye, plan);
    if (repeats) last_[eye] = Copy(image);
    last_noise_[eye] = plan.noise[eye];
  }
  return frame;
}

EyeImage SimCameras::See(Eye eye, const Plan& plan) {
  const Time t = plan.t_capture[eye];
  EyeCamera& camera = *eye_[eye];
  EyeMotion motion;
  std::vector<ViewPlan> plans;
  std::vector<LensView> views;
  WorldPoses& poses = at_capture_[eye] ? *at_capture_[eye] : at_capture_[eye].emplace();
  const auto render = [&] {
    plans = camera.Views(motion);
    const hardware::Pose X_WM = world_.X_WCamera(config_.mjcf_camera[eye]);
    for (const ViewPlan& view : plans) {
      RenderedView seen = renderer_.Render(X_WM * motion.PoseAt(view.t_s), view.camera,
                                           {.depth = view.needs_depth}, &times_);
      views.push_back({seen.bgr, seen.depth});
    }
  };
  if (t == clock_.Now()) {
    poses.Save(world_);
    render();
  } else {
    motion = history_.Motion(eye, t, half_window_);
    poses = history_.WorldOf(t);
    const WorldAt past(world_, poses);
    render();
  }
  return {times_.Measure("sensor",
                         [&] {
                           return camera.Develop(plans, std::move(views), motion, plan.noise[eye],
                                                 faults_.Light(eye, t));
                         }),
          t};
}

void SimCameras::AtCapture(Eye eye, const std::function<void()>& look) {
  if (!at_capture_[eye]) {
    look();
    return;
  }
  const WorldAt past(world_, *at_capture_[eye]);
  look();
}

}  // namespace horopter::sim
