// SPDX-License-Identifier: Apache-2.0
#include "sim/camera/frame_timing.h"

#include <gtest/gtest.h>

#include <cmath>

namespace horopter::sim {
namespace {

using hardware::Duration;
using hardware::FromSeconds;
using hardware::Time;
using std::chrono::microseconds;
using std::chrono::milliseconds;

constexpr Duration kStep = milliseconds(2);
constexpr Duration kWindow = milliseconds(20);
constexpr int kFrames = 4000;

FrameTiming Frames(const TimingProfile& timing, std::uint64_t seed = 1) {
  return FrameTiming(timing, kWindow, kStep, seed, "left");
}

TEST(FrameTiming, FramesComeAtTheRateOnWholeSteps) {
  const FrameTiming timing = Frames({.rate_hz = 30});
  const Time start = timing.At(0).t_capture.left;
  for (int n = 0; n < 300; ++n) {
    const Time t = timing.At(n).t_capture.left;
    EXPECT_EQ(t.time_since_epoch() % kStep, Duration(0));
    EXPECT_LE(std::abs(hardware::ToSeconds(t - start) - n / 30.0), 0.001) << n;
    EXPECT_EQ(t, timing.At(n).t_capture.right);
  }
}

TEST(FrameTiming, DeliveryIsTheLatencyAfterTheExposuresEnd) {
  const FrameTiming timing = Frames({.rate_hz = 25, .latency_s = 0.0615});
  for (int n = 0; n < 50; ++n) {
    const FrameTimes times = timing.At(n);
    EXPECT_EQ(times.t_delivered - times.t_capture.left, kWindow / 2 + microseconds(61500)) << n;
  }
}

TEST(FrameTiming, AFrameIsThereAtTimeZero) {
  for (const double latency_s : {0.0, 0.01, 0.5}) {
    for (const double skew_s : {-0.016, 0.0, 0.016}) {
      const FrameTiming timing = Frames({.rate_hz = 30,
                                         .latency_s = latency_s,
                                         .delivery_jitter_s = 0.01,
                                         .drop_probability = 0.5,
                                         .repeat_probability = 0.5,
                                         .skew_s = skew_s});
      EXPECT_LE(timing.At(0).t_delivered, Time{});
      EXPECT_FALSE(timing.At(0).dropped);
      EXPECT_FALSE(timing.At(0).repeated);
      const FrameTimes newest = timing.At(timing.NewestDelivered(Time{}));
      EXPECT_LE(newest.t_delivered, Time{});
    }
  }
}

TEST(FrameTiming, SkewDelaysTheRightEye) {
  for (const double skew_s : {0.016, -0.010}) {
    const FrameTiming timing = Frames({.rate_hz = 30, .skew_s = skew_s});
    for (int n = 0; n < 50; ++n) {
      const FrameTimes times = timing.At(n);
      EXPECT_EQ(times.t_capture.right - times.t_capture.left, FromSeconds(skew_s)) << n;
      EXPECT_EQ(times.t_delivered,
                std::max(times.t_capture.left, times.t_capture.right) + kWindow / 2);
    }
  }
}

TEST(FrameTiming, JittersFillTheirBoundsAndNoMore) {
  const FrameTiming regular = Frames({.rate_hz = 25, .latency_s = 0.03});
  const FrameTiming captures =
      Frames({.rate_hz = 25, .latency_s = 0.03, .capture_jitter_s = 0.008});
  const FrameTiming deliveries =
      Frames({.rate_hz = 25, .latency_s = 0.03, .delivery_jitter_s = 0.015});
  double earliest = 1, latest = -1, most = 0, sum = 0;
  for (int n = 1; n < kFrames; ++n) {
    const double early_or_late =
        hardware::ToSeconds(captures.At(n).t_capture.left - regular.At(n).t_capture.left);
    const double late =
        hardware::ToSeconds(deliveries.At(n).t_delivered - regular.At(n).t_delivered);
    ASSERT_LE(std::abs(early_or_late), 0.009) << "the bound and half a step";
    ASSERT_GE(late, 0);
    ASSERT_LE(late, 0.015);
    earliest = std::min(earliest, early_or_late), latest = std::max(latest, early_or_late);
    most = std::max(most, late), sum += late;
  }
  EXPECT_LE(earliest, -0.007);
  EXPECT_GE(latest, 0.007);
  EXPECT_GE(most, 0.0149);
  EXPECT_NEAR(sum / kFrames, 0.0075, 4 * 0.015 / std::sqrt(12.0 * kFrames));
}

TEST(FrameTiming, DropsAndRepeatsComeAsOftenAsStated) {
  const FrameTiming timing =
      Frames({.rate_hz = 25, .drop_probability = 0.2, .repeat_probability = 0.1});
  int dropped = 0, repeated = 0, both = 0;
  for (int n = 1; n < kFrames; ++n) {
    const FrameTimes times = timing.At(n);
    dropped += times.dropped, repeated += times.repeated, both += times.dropped && times.repeated;
  }
  const auto expect_share = [](int count, double p) {
    EXPECT_NEAR(count, p * kFrames, 4 * std::sqrt(p * (1 - p) * kFrames));
  };
  expect_share(dropped, 0.2);
  expect_share(repeated, 0.1);
  expect_share(both, 0.02);
}

TEST(FrameTiming, TurningOneEffectOnChangesNoOther) {
  const TimingProfile all{.rate_hz = 25,
                          .latency_s = 0.02,
                          .capture_jitter_s = 0.008,
                          .delivery_jitter_s = 0.01,
                          .drop_probability = 0.2,
                          .repeat_probability = 0.2};
  TimingProfile no_drops = all, no_repeats = all, no_capture_jitter = all;
  no_drops.drop_probability = 0;
  no_repeats.repeat_probability = 0;
  no_capture_jitter.capture_jitter_s = 0;
  for (int n = 0; n < 500; ++n) {
    const FrameTimes reference = Frames(all).At(n);
    const auto way = [](const FrameTimes& t) { return t.t_delivered - t.t_capture.left; };
    const FrameTimes all_delivered = Frames(no_drops).At(n),
                     none_repeated = Frames(no_repeats).At(n),
                     punctual = Frames(no_capture_jitter).At(n);
    EXPECT_EQ(all_delivered.repeated, reference.repeated);
    EXPECT_EQ(all_delivered.t_delivered, reference.t_delivered);
    EXPECT_EQ(none_repeated.dropped, reference.dropped);
    EXPECT_EQ(none_repeated.t_delivered, reference.t_delivered);
    EXPECT_EQ(punctual.dropped, reference.dropped);
    EXPECT_EQ(punctual.repeated, reference.repeated);
    EXPECT_EQ(way(punctual), way(reference)) << "however early the capture, the way takes as long";
  }
}

TEST(FrameTiming, SeedsDiffer) {
  const TimingProfile profile{.rate_hz = 25, .drop_probability = 0.5};
  int same = 0;
  for (int n = 1; n < 200; ++n)
    same += Frames(profile, 1).At(n).dropped == Frames(profile, 2).At(n).dropped;
  EXPECT_GT(same, 60);
  EXPECT_LT(same, 140);
}

TEST(FrameTiming, NewestDeliveredIsTheLastThatHasArrivedAndGoesOnlyForward) {
  const FrameTiming timing = Frames({.rate_hz = 30,
                                     .latency_s = 0.05,
                                     .capture_jitter_s = 0.008,
                                     .delivery_jitter_s = 0.016,
                                     .drop_probability = 0.3});
  std::uint64_t last = 0;
  for (Time now{}; now < Time(std::chrono::seconds(5)); now += milliseconds(3)) {
    std::uint64_t expected = 0;
    for (int n = 0; n < 160; ++n) {
      const FrameTimes times = timing.At(n);
      if (!times.dropped && times.t_delivered <= now) expected = n;
    }
    const std::uint64_t newest = timing.NewestDelivered(now);
    EXPECT_EQ(newest, expected);
    EXPECT_GE(newest, last);
    last = newest;
  }
  EXPECT_GT(last, 100u);
}

TEST(FrameTiming, ARepeatedFrameShowsTheLastOneThatWasReallyTaken) {
  const FrameTiming timing =
      Frames({.rate_hz = 25, .drop_probability = 0.3, .repeat_probability = 0.4});
  std::uint64_t last_taken = 0;
  int shown_again = 0;
  for (std::uint64_t n = 0; n < 500; ++n) {
    const FrameTimes times = timing.At(n);
    if (!times.dropped && !times.repeated) last_taken = n;
    EXPECT_EQ(timing.ShownBy(n), last_taken);
    shown_again += last_taken != n;
  }
  EXPECT_GT(shown_again, 100);
}

TEST(FrameTiming, NeedsARate) { EXPECT_THROW(Frames({.rate_hz = 0}), hardware::ConfigError); }

}  // namespace
}  // namespace horopter::sim
