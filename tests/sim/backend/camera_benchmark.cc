// SPDX-License-Identifier: Apache-2.0
// What a real camera costs beside rendering a plain VGA pair of the Koala's room:
//   horopter_benchmark_sim_backend --benchmark_min_time=0.5
// "of_plain_pair" is the time over that of the plain pair, taken in the same run; the aim
// for sensor, motion blur and rolling shutter together is 0.25 on two cores.
#include <benchmark/benchmark.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <opencv2/core/utility.hpp>
#include <vector>

#include "hardware/types/eye.h"
#include "sim/camera/eye_camera.h"
#include "sim/render/renderer.h"
#include "sim/world/world.h"

namespace horopter::sim {
namespace {

using hardware::CameraModel;
using hardware::Eye;
using Clock = std::chrono::steady_clock;

constexpr double kFov_rad = 1.0471975512;
constexpr double kSaccade_rad_s = 2.0943951024;  // 120 deg/s, the Koala's set speed

/// The room and a renderer, made once.
struct Room {
  Room() : renderer(world, {"osmesa", 1200, 900}) {}

  void RenderPair(const CameraModel& camera, hardware::PerEye<cv::Mat3b>& views) {
    for (const Eye eye : hardware::kBothEyes) {
      views[eye] = renderer.Render(world.X_WCamera(ToString(eye)), camera).bgr;
    }
  }

  World world{std::filesystem::path(HOROPTER_SOURCE_DIR) / "scenes" / "koala" / "room.xml"};
  Renderer renderer;
};

Room& TheRoom() {
  static Room room;
  return room;
}

/// Median time of a plain pair [s].
double PlainPair() {
  static const double seconds = [] {
    const CameraModel camera = CameraModel::FromHorizontalFov(640, 480, kFov_rad);
    hardware::PerEye<cv::Mat3b> views;
    std::vector<double> times;
    for (int i = 0; i < 25; ++i) {
      const auto begun = Clock::now();
      TheRoom().RenderPair(camera, views);
      times.push_back(std::chrono::duration<double>(Clock::now() - begun).count());
    }
    std::nth_element(times.begin(), times.begin() + 12, times.end());
    return times[12];
  }();
  return seconds;
}

EyeMotion Turning(double speed_rad_s, double window_s) {
  EyeMotion motion;
  const Eigen::Vector3d axis = Eigen::Vector3d(0.3, 1, 0).normalized();
  for (double t_s = -window_s / 2 - 0.002; t_s < window_s / 2 + 0.004; t_s += 0.002) {
    motion.Add(t_s, Eigen::AngleAxisd(speed_rad_s * t_s, axis).toRotationMatrix());
  }
  return motion;
}

CameraProfile Only(const char* part) {
  const CameraProfile all = CameraProfile::Named("lifecam_vx6000");
  const std::string_view which(part);
  CameraProfile profile;
  if (which == "lens") profile.lens = all.lens;
  if (which == "noise") profile.noise = all.noise;
  if (which == "vignetting") profile.lens.vignetting = all.lens.vignetting;
  if (which == "shutter") profile.shutter = all.shutter;
  if (which == "motion_blur") profile.exposure = all.exposure;
  if (which == "sensor_and_motion") {  // all but what the lens does to places
    profile = all;
    profile.lens.distortion = {};
  }
  if (which == "everything") profile = all;
  return profile;
}

void DevelopPair(benchmark::State& state, const char* part, double speed_rad_s) {
  const double plain_s = PlainPair();
  const CameraProfile profile = Only(part);
  const CameraModel model = profile.lens.Model(640, 480, kFov_rad);
  EyeCamera eye(model, profile, 1, "left");
  const EyeMotion motion =
      speed_rad_s > 0 ? Turning(speed_rad_s, eye.exposure().window_s()) : EyeMotion();
  hardware::PerEye<cv::Mat3b> views;
  TheRoom().RenderPair(eye.View(motion), views);
  std::uint64_t frame = 0;
  const auto begun = Clock::now();
  for (auto _ : state) {
    for (const Eye e : hardware::kBothEyes) {
      benchmark::DoNotOptimize(eye.Develop(views[e], motion, frame));
    }
    ++frame;
  }
  const double seconds = std::chrono::duration<double>(Clock::now() - begun).count();
  state.counters["of_plain_pair"] = seconds / static_cast<double>(state.iterations()) / plain_s;
}

void RenderPair(benchmark::State& state, const char* part, double speed_rad_s) {
  const double plain_s = PlainPair();
  const CameraProfile profile = Only(part);
  EyeCamera eye(profile.lens.Model(640, 480, kFov_rad), profile, 1, "left");
  const EyeMotion motion =
      speed_rad_s > 0 ? Turning(speed_rad_s, eye.exposure().window_s()) : EyeMotion();
  const CameraModel view = eye.View(motion);
  hardware::PerEye<cv::Mat3b> views;
  const auto begun = Clock::now();
  for (auto _ : state) TheRoom().RenderPair(view, views);
  const double seconds = std::chrono::duration<double>(Clock::now() - begun).count();
  state.counters["of_plain_pair"] = seconds / static_cast<double>(state.iterations()) / plain_s;
  state.counters["megapixels"] = view.width() * view.height() * 1e-6;
}

#define HOROPTER_PAIR(function, name, part, speed) \
  BENCHMARK_CAPTURE(function, name, part, speed)->Unit(benchmark::kMillisecond)->UseRealTime()

HOROPTER_PAIR(RenderPair, plain, "nothing", 0);
HOROPTER_PAIR(RenderPair, for_lens, "lens", 0);
HOROPTER_PAIR(RenderPair, for_saccade, "sensor_and_motion", kSaccade_rad_s);
HOROPTER_PAIR(RenderPair, for_everything_in_saccade, "everything", kSaccade_rad_s);
HOROPTER_PAIR(DevelopPair, noise, "noise", 0);
HOROPTER_PAIR(DevelopPair, vignetting, "vignetting", 0);
HOROPTER_PAIR(DevelopPair, lens_and_blur, "lens", 0);
HOROPTER_PAIR(DevelopPair, rolling_shutter_in_saccade, "shutter", kSaccade_rad_s);
HOROPTER_PAIR(DevelopPair, motion_blur_in_saccade, "motion_blur", kSaccade_rad_s);
HOROPTER_PAIR(DevelopPair, sensor_and_motion_in_saccade, "sensor_and_motion", kSaccade_rad_s);
HOROPTER_PAIR(DevelopPair, everything_at_rest, "everything", 0);
HOROPTER_PAIR(DevelopPair, everything_in_saccade, "everything", kSaccade_rad_s);

}  // namespace
}  // namespace horopter::sim
