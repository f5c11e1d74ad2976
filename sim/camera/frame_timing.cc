// SPDX-License-Identifier: Apache-2.0
#include "sim/camera/frame_timing.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "sim/random/random_stream.h"

namespace horopter::sim {
namespace {

using hardware::Duration;
using hardware::FromSeconds;
using hardware::Time;

std::uint64_t Stream(std::uint64_t seed, const char* what, std::string_view camera) {
  return RandomStream(seed, std::string("camera.") + what + "." + std::string(camera)).Next();
}

}  // namespace

FrameTiming::FrameTiming(const TimingProfile& timing, Duration window, Duration step,
                         std::uint64_t seed, std::string_view camera)
    : timing_(timing),
      half_window_(window / 2),
      step_(step),
      capture_jitter_(Stream(seed, "capture_jitter", camera)),
      delivery_jitter_(Stream(seed, "delivery_jitter", camera)),
      drop_(Stream(seed, "drop", camera)),
      repeat_(Stream(seed, "repeat", camera)) {
  if (!(timing.rate_hz > 0)) {
    throw hardware::ConfigError(
        {{"camera.timing.rate_hz", std::to_string(timing.rate_hz), "must be positive"}});
  }
  const Duration later_eye = FromSeconds(std::max(0.0, timing.skew_s));
  // A step more on top, since rounding may move a capture by half a step each.
  start_ = Snap(Time{} - half_window_ - FromSeconds(timing.latency_s) - later_eye - step);
}

Time FrameTiming::Snap(Time t) const {
  const double steps =
      static_cast<double>(t.time_since_epoch().count()) / static_cast<double>(step_.count());
  return Time(static_cast<std::int64_t>(std::floor(steps + 0.5)) * step_);
}

FrameTimes FrameTiming::At(std::uint64_t frame) const {
  FrameTimes times;
  Duration early_or_late{}, delay{};
  if (frame > 0) {
    early_or_late =
        FromSeconds(timing_.capture_jitter_s * (2 * UniformOf(capture_jitter_, frame) - 1));
    delay = FromSeconds(timing_.delivery_jitter_s * UniformOf(delivery_jitter_, frame));
    times.dropped = UniformOf(drop_, frame) < timing_.drop_probability;
    times.repeated = UniformOf(repeat_, frame) < timing_.repeat_probability;
  }
  const Time left =
      start_ + FromSeconds(static_cast<double>(frame) / timing_.rate_hz) + early_or_late;
  times.t_capture = {Snap(left), Snap(left + FromSeconds(timing_.skew_s))};
  times.t_delivered = std::max(times.t_capture.left, times.t_capture.right) + half_window_ +
                      FromSeconds(timing_.latency_s) + delay;
  return times;
}

std::uint64_t FrameTiming::NewestDelivered(Time now) const {
  const double periods = hardware::ToSeconds(now - start_) * timing_.rate_hz;
  auto frame = static_cast<std::uint64_t>(std::max(0.0, std::ceil(periods) + 1));
  for (; frame > 0; --frame) {
    const FrameTimes times = At(frame);
    if (!times.dropped && times.t_delivered <= now) break;
  }
  return frame;
}

std::uint64_t FrameTiming::ShownBy(std::uint64_t frame) const {
  while (frame > 0) {
    const FrameTimes times = At(frame);
    if (!times.dropped && !times.repeated) break;
    --frame;
  }
  return frame;
}

}  // namespace horopter::sim
