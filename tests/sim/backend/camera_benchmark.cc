// SPDX-License-Identifier: Apache-2.0
// What a real camera costs on top of a plain VGA pair of the Koala's painted room:
//   horopter_benchmark_sim_backend --benchmark_min_time=2
// Every iteration takes a plain pair and one with the effects, in turns; "over_plain" is how much
// longer the latter takes in the median, with all that it needs: the larger view or the views of a
// shutter's rows, and developing. The aim for sensor, motion blur and rolling shutter, each apart,
// is 0.25 on two cores.
#include <benchmark/benchmark.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <string_view>
#include <utility>
#include <vector>

#include "hardware/types/eye.h"
#include "sim/camera/eye_camera.h"
#include "sim/render/renderer.h"
#include "sim/textures/paint_textures.h"
#include "sim/world/world.h"

namespace horopter::sim {
namespace {

using hardware::CameraModel;
using hardware::Eye;
using Clock = std::chrono::steady_clock;

constexpr double kFov_rad = 1.0471975512;

/// How an eye turns: its speed, and how far its optical centre is from the axis.
struct Turn {
  double speed_rad_s = 0;
  double lever_m = 0;
};
constexpr Turn kRest{};
constexpr Turn kKoala{2.0943951024, 0};  // 120 deg/s, its set speed
constexpr Turn kNao{8.27, 0.08};         // as fast as it can

/// The painted room and a renderer, made once.
struct Room {
  Room() {
    PaintTextures(world.mutable_model(), 1);
    renderer = std::make_unique<Renderer>(
        world, RendererOptions{.gl_backend = "osmesa", .width = 1200, .height = 900});
  }

  World world{std::filesystem::path(HOROPTER_SOURCE_DIR) / "scenes" / "koala" / "room.xml"};
  std::unique_ptr<Renderer> renderer;
};

Room& TheRoom() {
  static Room room;
  return room;
}

EyeMotion Turning(const Turn& turning, double window_s) {
  EyeMotion motion;
  if (turning.speed_rad_s == 0) return motion;
  const Eigen::Vector3d axis = Eigen::Vector3d(0.3, 1, 0).normalized();
  const Eigen::Vector3d lever(0, 0, turning.lever_m);
  for (double t_s = -window_s / 2 - 0.002; t_s < window_s / 2 + 0.004; t_s += 0.002) {
    const Eigen::AngleAxisd turn(turning.speed_rad_s * t_s, axis);
    motion.Add(t_s, turn.toRotationMatrix(), turn * lever - lever);
  }
  return motion;
}

void PlainPair(const CameraModel& camera) {
  for (const Eye eye : hardware::kBothEyes) {
    benchmark::DoNotOptimize(
        TheRoom().renderer->Render(TheRoom().world.X_WCamera(ToString(eye)), camera));
  }
}

void RealPair(EyeCamera& camera, const EyeMotion& motion, std::uint64_t frame) {
  for (const Eye eye : hardware::kBothEyes) {
    const hardware::Pose X_WM = TheRoom().world.X_WCamera(ToString(eye));
    const std::vector<ViewPlan> plans = camera.Views(motion);
    std::vector<LensView> views;
    for (const ViewPlan& plan : plans) {
      const RenderedView seen = TheRoom().renderer->Render(
          X_WM * motion.PoseAt(plan.t_s), plan.camera, {.depth = plan.needs_depth});
      views.push_back({seen.bgr, seen.depth});
    }
    benchmark::DoNotOptimize(camera.Develop(plans, std::move(views), motion, frame));
  }
}

template <typename Work>
double Seconds(Work&& work) {
  const auto begun = Clock::now();
  work();
  return std::chrono::duration<double>(Clock::now() - begun).count();
}

double Median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
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

void OnTopOfPlain(benchmark::State& state, const char* part, const Turn& turning) {
  const CameraProfile profile = Only(part);
  const CameraModel plain_camera = CameraModel::FromHorizontalFov(640, 480, kFov_rad);
  EyeCamera camera(profile.lens.Model(640, 480, kFov_rad), profile, 1, "left");
  const EyeMotion motion = Turning(turning, camera.exposure().window_s());
  PlainPair(plain_camera);
  RealPair(camera, motion, 0);
  std::vector<double> plain_s, real_s, ratio;
  std::uint64_t frame = 1;
  for (auto _ : state) {
    plain_s.push_back(Seconds([&] { PlainPair(plain_camera); }));
    real_s.push_back(Seconds([&] { RealPair(camera, motion, frame++); }));
    ratio.push_back(real_s.back() / plain_s.back());
    state.SetIterationTime(real_s.back());
  }
  state.counters["plain_ms"] = 1000 * Median(plain_s);
  state.counters["over_plain"] = Median(ratio) - 1;
  state.counters["views"] = static_cast<double>(camera.Views(motion).size());
}

#define HOROPTER_EFFECT(name, part, turning)           \
  BENCHMARK_CAPTURE(OnTopOfPlain, name, part, turning) \
      ->Unit(benchmark::kMillisecond)                  \
      ->UseManualTime()

HOROPTER_EFFECT(nothing, "nothing", kRest);
HOROPTER_EFFECT(noise, "noise", kRest);
HOROPTER_EFFECT(vignetting, "vignetting", kRest);
HOROPTER_EFFECT(lens_and_blur, "lens", kRest);
HOROPTER_EFFECT(rolling_shutter_at_rest, "shutter", kRest);
HOROPTER_EFFECT(rolling_shutter_in_saccade, "shutter", kKoala);
HOROPTER_EFFECT(rolling_shutter_in_nao_saccade, "shutter", kNao);
HOROPTER_EFFECT(motion_blur_at_rest, "motion_blur", kRest);
HOROPTER_EFFECT(motion_blur_in_saccade, "motion_blur", kKoala);
HOROPTER_EFFECT(sensor_and_motion_in_saccade, "sensor_and_motion", kKoala);
HOROPTER_EFFECT(motion_blur_in_nao_saccade, "motion_blur", kNao);
HOROPTER_EFFECT(everything_at_rest, "everything", kRest);
HOROPTER_EFFECT(everything_in_saccade, "everything", kKoala);

}  // namespace
}  // namespace horopter::sim
