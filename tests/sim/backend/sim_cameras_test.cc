// SPDX-License-Identifier: Apache-2.0
#include "sim/backend/sim_cameras.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <opencv2/core.hpp>

#include "tests/sim/backend/spot_board.h"
#include "tests/sim/camera/spots.h"

namespace horopter::sim {
namespace {

using hardware::CameraModel;
using hardware::Eye;
using hardware::FromSeconds;
using hardware::StereoFrame;
using hardware::Time;
using std::chrono::milliseconds;

const auto kData = std::filesystem::path(HOROPTER_SOURCE_DIR) / "tests/sim/backend/data";
const hardware::Intrinsics kSmall{160, 120, 140, 140, 79.5, 59.5};

bool SamePixels(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && cv::norm(a, b, cv::NORM_INF) == 0;
}

/// Two cameras that turn to the left at a constant speed before a wall that ends straight ahead.
class Spinner {
 public:
  explicit Spinner(const CameraProfile& profile, double speed_rad_s = 1.0,
                   const CameraModel& model = CameraModel(kSmall))
      : Spinner(SimCamerasConfig{.model = {model, model}, .profile = profile}, speed_rad_s) {}

  Spinner(const SimCamerasConfig& config, double speed_rad_s)
      : renderer_(world_,
                  {.width = config.RenderSize().width, .height = config.RenderSize().height}),
        clock_(
            world_, [this] { world_.Step(); }, times_),
        cameras(world_, renderer_, clock_, config, times_) {
    for (int joint = 0; joint < world_.model().nv; ++joint) {
      world_.mutable_data().qvel[joint] = speed_rad_s;
    }
    EXPECT_TRUE(cameras.Configure().ok());
    EXPECT_TRUE(cameras.Activate().ok());
  }

  StereoFrame GrabAt(Time t) {
    clock_.SleepUntil(t);
    return cameras.Grab().value();
  }
  StereoFrame GrabAt(double seconds) { return GrabAt(Time(FromSeconds(seconds))); }

  World& world() { return world_; }
  Time Now() const { return clock_.Now(); }
  double pan() const { return world_.data().qpos[0]; }

 private:
  World world_{kData / "spinner.xml"};
  Renderer renderer_;
  hardware::StageTimes times_;
  SimClock clock_;

 public:
  SimCameras cameras;
};

/// What ideal cameras saw at each physics step of half a second.
const std::map<Time, StereoFrame>& IdealFrames() {
  static const auto frames = [] {
    std::map<Time, StereoFrame> all;
    Spinner spinner{CameraProfile{}};
    for (Time t{}; t <= Time(milliseconds(300)); t += milliseconds(2)) {
      all[t] = spinner.GrabAt(t);
    }
    return all;
  }();
  return frames;
}

const cv::Mat& IdealAt(Eye eye, Time t) { return IdealFrames().at(std::max(t, Time{}))[eye].bgr; }

CameraProfile Timed(const TimingProfile& timing) {
  CameraProfile profile;
  profile.timing = timing;
  return profile;
}

TEST(SimCameras, IdealCamerasShowNow) {
  for (const auto& [t, frame] : IdealFrames()) {
    EXPECT_EQ(frame.left.t_capture, t);
    EXPECT_EQ(frame.right.t_capture, t);
    EXPECT_EQ(frame.t_delivered, t);
  }
  EXPECT_FALSE(
      SamePixels(IdealAt(Eye::kLeft, Time{}), IdealAt(Eye::kLeft, Time(milliseconds(50)))));
}

TEST(SimCameras, LatencyShowsThePastAsItWas) {
  Spinner spinner(Timed({.latency_s = 0.050}));
  for (const double seconds : {0.0, 0.02, 0.06, 0.1, 0.29}) {
    const StereoFrame frame = spinner.GrabAt(seconds);
    EXPECT_EQ(frame.t_delivered, Time(FromSeconds(seconds)));
    for (const Eye eye : hardware::kBothEyes) {
      EXPECT_EQ(frame[eye].t_capture, frame.t_delivered - milliseconds(50));
      EXPECT_TRUE(SamePixels(frame[eye].bgr, IdealAt(eye, frame[eye].t_capture))) << seconds;
    }
  }
}

TEST(SimCameras, LookingBackChangesNothingInTheWorld) {
  Spinner looking(Timed({.rate_hz = 30, .latency_s = 0.04})), blind(CameraProfile{});
  for (int i = 0; i < 10; ++i) {
    const StereoFrame frame = looking.GrabAt(0.02 * i);
    blind.GrabAt(0.02 * i);
    EXPECT_EQ(looking.pan(), blind.pan());
    EXPECT_EQ(looking.world().X_WCamera("left").matrix(), blind.world().X_WCamera("left").matrix());
  }
}

TEST(SimCameras, AtARateTheNewestDeliveredFrameComesAndTheSameAgainUntilTheNext) {
  Spinner spinner(Timed({.rate_hz = 25, .latency_s = 0.030}));
  StereoFrame last = spinner.GrabAt(0);
  int fresh = 0;
  for (double seconds = 0.004; seconds < 0.3; seconds += 0.004) {
    const StereoFrame frame = spinner.GrabAt(seconds);
    EXPECT_LE(frame.t_delivered, spinner.Now());
    EXPECT_EQ(frame.t_delivered - frame.left.t_capture, milliseconds(30));
    EXPECT_LT(spinner.Now() - frame.t_delivered, milliseconds(40));
    EXPECT_TRUE(SamePixels(frame.right.bgr, IdealAt(Eye::kRight, frame.right.t_capture)));
    if (frame.sequence != last.sequence) {
      ++fresh;
      EXPECT_EQ(frame.sequence, last.sequence + 1);
      EXPECT_EQ(frame.left.t_capture - last.left.t_capture, milliseconds(40));
    } else {
      EXPECT_EQ(frame.left.t_capture, last.left.t_capture);
      EXPECT_TRUE(SamePixels(frame.left.bgr, last.left.bgr));
      EXPECT_NE(frame.left.bgr.data, last.left.bgr.data) << "frames own their pixels";
    }
    last = frame;
  }
  EXPECT_NEAR(fresh, 7, 1);
}

TEST(SimCameras, WhichFramesAreGrabbedChangesNoFrame) {
  CameraProfile profile = CameraProfile::Named("webcam_vga");
  profile.timing.drop_probability = 0.2;
  Spinner often(profile), seldom(profile);
  std::map<std::uint64_t, StereoFrame> all;
  for (int i = 0; i <= 100; ++i) {
    const StereoFrame frame = often.GrabAt(0.004 * i);
    all[frame.sequence] = frame;
  }
  for (const double seconds : {0.132, 0.4}) {
    const StereoFrame frame = seldom.GrabAt(seconds);
    const StereoFrame& other = all.at(frame.sequence);
    EXPECT_EQ(frame.left.t_capture, other.left.t_capture);
    EXPECT_TRUE(SamePixels(frame.left.bgr, other.left.bgr));
    EXPECT_TRUE(SamePixels(frame.right.bgr, other.right.bgr));
  }
}

TEST(SimCameras, SkewShowsEachEyeItsOwnInstant) {
  for (const double rate_hz : {0.0, 25.0}) {
    for (const double skew_s : {0.016, -0.010}) {
      Spinner spinner(Timed({.rate_hz = rate_hz, .skew_s = skew_s}));
      for (const double seconds : {0.1, 0.2, 0.25}) {
        const StereoFrame frame = spinner.GrabAt(seconds);
        EXPECT_EQ(frame.right.t_capture - frame.left.t_capture, FromSeconds(skew_s));
        for (const Eye eye : hardware::kBothEyes) {
          EXPECT_TRUE(SamePixels(frame[eye].bgr, IdealAt(eye, frame[eye].t_capture)));
        }
      }
    }
  }
}

TEST(SimCameras, ADroppedFrameNeverComesAndARepeatedOneShowsTheLastAgain) {
  const TimingProfile timing{.rate_hz = 50, .drop_probability = 0.3, .repeat_probability = 0.4};
  Spinner spinner(Timed(timing));
  const FrameTiming plan(timing, FromSeconds(0), milliseconds(2), 1, "left");
  int repeated = 0, dropped = 0;
  std::uint64_t last = 0;
  for (double seconds = 0; seconds < 0.3; seconds += 0.01) {
    const StereoFrame frame = spinner.GrabAt(seconds);
    EXPECT_FALSE(plan.At(frame.sequence).dropped);
    for (std::uint64_t n = last + 1; n < frame.sequence; ++n) dropped += plan.At(n).dropped;
    const Time taken = plan.At(plan.ShownBy(frame.sequence)).t_capture.left;
    EXPECT_EQ(frame.left.t_capture, taken);
    EXPECT_TRUE(SamePixels(frame.left.bgr, IdealAt(Eye::kLeft, taken)));
    repeated += frame.sequence != last && plan.At(frame.sequence).repeated;
    last = frame.sequence;
  }
  EXPECT_GT(dropped, 0);
  EXPECT_GT(repeated, 0);
}

TEST(SimCameras, AtCaptureShowsTheWorldOfTheNewestImage) {
  Spinner spinner(Timed({.latency_s = 0.05, .skew_s = 0.02}));
  spinner.cameras.AtCapture(Eye::kLeft, [&] { EXPECT_EQ(spinner.pan(), 0); });
  const StereoFrame frame = spinner.GrabAt(0.2);
  const double now = spinner.pan();
  for (const Eye eye : hardware::kBothEyes) {
    double then = 0;
    spinner.cameras.AtCapture(eye, [&] { then = spinner.pan(); });
    EXPECT_NEAR(then, hardware::ToSeconds(frame[eye].t_capture), 1e-9) << "1 rad/s";
  }
  EXPECT_EQ(spinner.pan(), now);
}

TEST(SimCameras, ALostFrameIsStaleByAFrameOfTheCameraHoweverSeldomItIsGrabbed) {
  SimCamerasConfig config{.model = {CameraModel(kSmall), CameraModel(kSmall)},
                          .profile = Timed({.rate_hz = 50}),
                          .faults = {{LostFrames{Eye::kLeft, 0.4}}}};
  const FrameFaults faults(config.faults, config.seed);
  const FrameTiming plan(config.profile.timing, FromSeconds(0), milliseconds(2), 1, "left");
  Spinner often(config, 1), seldom(config, 1);
  std::map<std::uint64_t, StereoFrame> all;
  int lost = 0;
  for (double seconds = 0; seconds < 0.3; seconds += 0.01) {
    const StereoFrame frame = often.GrabAt(seconds);
    std::uint64_t shown = frame.sequence;
    while (shown > 0 && faults.Loses(Eye::kLeft, shown, plan.At(shown).t_capture.left)) --shown;
    lost += shown != frame.sequence;
    EXPECT_EQ(frame.left.t_capture, plan.At(shown).t_capture.left);
    EXPECT_EQ(frame.right.t_capture, plan.At(frame.sequence).t_capture.right);
    EXPECT_TRUE(SamePixels(frame.left.bgr, IdealAt(Eye::kLeft, frame.left.t_capture)));
    EXPECT_TRUE(SamePixels(frame.right.bgr, IdealAt(Eye::kRight, frame.right.t_capture)));
    all[frame.sequence] = frame;
  }
  EXPECT_GT(lost, 3);
  for (const double seconds : {0.08, 0.22, 0.28}) {
    const StereoFrame frame = seldom.GrabAt(seconds), again = seldom.GrabAt(seconds);
    EXPECT_EQ(frame.left.t_capture, all.at(frame.sequence).left.t_capture);
    EXPECT_EQ(again.left.t_capture, frame.left.t_capture) << "a frame is lost once and for all";
    EXPECT_TRUE(SamePixels(frame.left.bgr, all.at(frame.sequence).left.bgr));
  }
}

TEST(SimCameras, WithoutARateALostFrameIsTheLastThatWasGrabbed) {
  SimCamerasConfig config{.model = {CameraModel(kSmall), CameraModel(kSmall)},
                          .faults = {{LostFrames{Eye::kRight, 0.4}}}};
  const FrameFaults faults(config.faults, config.seed);
  Spinner spinner(config, 1);
  StereoFrame last = spinner.GrabAt(0);
  int lost = 0;
  for (std::uint64_t n = 1; n < 20; ++n) {
    const StereoFrame frame = spinner.GrabAt(0.01 * static_cast<double>(n));
    ASSERT_EQ(frame.sequence, n);
    const bool is_lost = faults.Loses(Eye::kRight, n, spinner.Now());
    lost += is_lost;
    EXPECT_EQ(frame.right.t_capture, is_lost ? last.right.t_capture : spinner.Now());
    EXPECT_EQ(frame.left.t_capture, spinner.Now());
    EXPECT_TRUE(SamePixels(frame.right.bgr, IdealAt(Eye::kRight, frame.right.t_capture)));
    last = frame;
  }
  EXPECT_GT(lost, 3);
}

TEST(SimCameras, ADarkEyeKeepsTheNoiseOfItsSensor) {
  CameraProfile profile;
  profile.noise = {.read_noise_dn = 4};
  SimCamerasConfig config{.model = {CameraModel(kSmall), CameraModel(kSmall)},
                          .profile = profile,
                          .faults = {{DarkEye{Eye::kLeft, 0}}}};
  const StereoFrame dark = Spinner(config, 0).GrabAt(0.01);
  config.faults.clear();
  const StereoFrame lit = Spinner(config, 0).GrabAt(0.01);
  cv::Scalar mean, deviation;
  cv::meanStdDev(dark.left.bgr, mean, deviation);
  // Of normal noise that is cut off at zero: 0.399 and 0.584 standard deviations.
  EXPECT_NEAR(mean[0], 0.399 * 4, 0.1);
  EXPECT_NEAR(deviation[0], 0.584 * 4, 0.1);
  EXPECT_TRUE(SamePixels(dark.right.bgr, lit.right.bgr));
}

/// Mean of where a row rises from dark to bright.
double EdgeIn(const cv::Mat& image, int row) {
  double mass = 0, mean = 0;
  for (int x = 1; x < image.cols; ++x) {
    const double slope = image.at<cv::Vec3b>(row, x)[0] - 1.0 * image.at<cv::Vec3b>(row, x - 1)[0];
    mass += slope, mean += slope * (x - 0.5);
  }
  return mean / mass;
}

TEST(SimCameras, RollingShutterLeansAnEdgeByTheEyesOwnMotion) {
  constexpr double kSpeed_rad_s = 1.5, kReadout_s = 0.030;
  CameraProfile profile;
  profile.shutter = {Shutter::kRolling, kReadout_s};
  Spinner spinner(profile, kSpeed_rad_s);
  const StereoFrame frame = spinner.GrabAt(0.1);
  EXPECT_EQ(frame.t_delivered - frame.left.t_capture, milliseconds(16))
      << "half the readout, whole steps";
  const double t_s = hardware::ToSeconds(frame.left.t_capture);
  for (const int row : {0, 30, 60, 90, 119}) {
    // The wall ends straight ahead at pan 0; turning to the left moves it to the right.
    const double pan = kSpeed_rad_s * (t_s + kReadout_s * (row / 119.0 - 0.5));
    const double expected = kSmall.cx + kSmall.fx * std::tan(pan);
    EXPECT_NEAR(EdgeIn(frame.left.bgr, row), expected, 0.5) << row << ": one sample per pixel";
  }
  const double lean = EdgeIn(frame.left.bgr, 119) - EdgeIn(frame.left.bgr, 0);
  const double across = kSmall.fx * kSpeed_rad_s * kReadout_s;
  EXPECT_NEAR(lean, across, 0.1 * across);
}

TEST(SimCameras, InterlacedFieldsAreHalfAFrameApart) {
  CameraProfile profile;
  profile.shutter = {Shutter::kInterlaced, 0.020};
  profile.timing.rate_hz = 25;
  Spinner spinner(profile);
  const StereoFrame frame = spinner.GrabAt(0.16);
  const double t_s = hardware::ToSeconds(frame.left.t_capture);
  for (const int row : {40, 41, 80, 81}) {
    const double pan = t_s + (row % 2 == 0 ? -0.010 : 0.010);
    EXPECT_NEAR(EdgeIn(frame.left.bgr, row), kSmall.cx + kSmall.fx * std::tan(pan), 0.5) << row;
  }
}

TEST(SimCameras, AnEyeAtRestSeesTheSameThroughAnyShutter) {
  CameraProfile shuttered;
  shuttered.shutter = {Shutter::kRolling, 0.030};
  shuttered.exposure.time_s = 0.010;
  Spinner moved(CameraProfile{}, 0), rested(shuttered, 0);
  EXPECT_TRUE(SamePixels(moved.GrabAt(0.1).left.bgr, rested.GrabAt(0.1).left.bgr));
}

TEST(SimCameras, EachEffectKeepsItsNoiseWhenAnotherIsTurnedOn) {
  CameraProfile noisy;
  noisy.noise = {.read_noise_dn = 5};
  noisy.timing = {.rate_hz = 25};
  CameraProfile dropping = noisy, jittered = noisy;
  dropping.timing.drop_probability = 0.4;
  jittered.timing.delivery_jitter_s = 0.015;
  Spinner reference(noisy, 0);
  std::map<std::uint64_t, StereoFrame> frames;
  for (int i = 0; i < 30; ++i) {
    const StereoFrame frame = reference.GrabAt(0.02 * i);
    frames[frame.sequence] = frame;
  }
  for (const CameraProfile& profile : {dropping, jittered}) {
    Spinner spinner(profile, 0);
    for (const double seconds : {0.1, 0.3, 0.5}) {
      const StereoFrame frame = spinner.GrabAt(seconds);
      EXPECT_TRUE(SamePixels(frame.left.bgr, frames.at(frame.sequence).left.bgr));
      EXPECT_FALSE(SamePixels(frame.left.bgr, frame.right.bgr)) << "each eye has its own";
    }
  }
}

TEST(SimCameras, ImagesAreThoseOfTheModelWithItsDistortion) {
  LensProfile lens{.distortion = {.k1 = -0.25, .k2 = 0.08, .p1 = 0.003, .p2 = -0.002},
                   .principal_point_offset_px = {9, -7},
                   .pixel_aspect = 0.95};
  const CameraModel camera = lens.Model(320, 240, 1.05);
  World world(kData / "spinner.xml");
  const SpotBoard board(world);
  hardware::Pose X_CT = hardware::Pose::Identity();
  X_CT.translation().z() = 0.9;
  const hardware::Pose X_WC = world.X_WCamera("left");
  world.PlaceBody("spot_board", X_WC * X_CT);
  const SimCamerasConfig config{.model = {camera, camera}, .profile = {}};
  Renderer renderer(world,
                    {.width = config.RenderSize().width, .height = config.RenderSize().height});
  hardware::StageTimes times;
  SimClock clock(
      world, [&] { world.Step(); }, times);
  SimCameras cameras(world, renderer, clock, config, times);
  ASSERT_TRUE(cameras.Configure().ok());
  ASSERT_TRUE(cameras.Activate().ok());
  const cv::Mat3b image = cameras.Grab().value().left.bgr;
  int seen = 0;
  for (const Eigen::Vector3d& p_T : SpotBoard::Centres()) {
    const auto expected = cameras.model(Eye::kLeft).Project(X_CT * p_T);
    if (!expected || expected->minCoeff() < 12 || expected->x() > 308 || expected->y() > 228)
      continue;
    ++seen;
    EXPECT_LT((CentroidAround(image, *expected) - *expected).norm(), 0.05) << expected->transpose();
  }
  EXPECT_GT(seen, 60);
}

TEST(SimCameras, RefusesWhatNoPinholeCovers) {
  const CameraModel folded(kSmall, {.k1 = -2.5});
  EXPECT_THROW(Spinner(CameraProfile{}, 0, folded), hardware::ConfigError);
}

}  // namespace
}  // namespace horopter::sim
