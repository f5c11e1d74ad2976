// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/v1_closed_form.h"

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstring>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <string>
#include <thread>
#include <tuple>
#include <utility>
#include <vector>

#include "on_threads.h"
#include "textured_pair.h"
#include "vision/disparity/v1_config.h"

namespace horopter::vision {
namespace {

using testing::OnThreads;
using testing::ScoreWarp;
using testing::ShiftedPair;
using testing::SyntheticPair;
using testing::WarpedPair;
using testing::WarpScore;

const cv::Size kSize(192, 144);

cv::Matx33d Shift(double dx, double dy) { return {1, 0, dx, 0, 1, dy, 0, 0, 1}; }

ClosedFormConfig Preset(const std::string& name) { return V1Config::Preset(name).closed_form; }

DisparityField Estimate(const ClosedFormConfig& config, const SyntheticPair& pair,
                        const std::string& kernels = "") {
  return V1ClosedFormEstimator(config, kernels).Estimate(pair.left, pair.right);
}

/// A pair that the closed form matches at full size.
SyntheticPair CleanPair(cv::Size size, double dx, double dy) {
  return ShiftedPair(size, dx, dy, 1, testing::kCleanTexturePx);
}

void ExpectSameBits(const DisparityField& a, const DisparityField& b) {
  for (const auto& [one, other] : {std::pair<cv::Mat, cv::Mat>{a.dx, b.dx},
                                   {a.dy, b.dy},
                                   {a.confidence, b.confidence},
                                   {a.valid, b.valid}}) {
    ASSERT_EQ(one.size(), other.size());
    for (int y = 0; y < one.rows; ++y) {
      ASSERT_EQ(std::memcmp(one.ptr(y), other.ptr(y), one.cols * one.elemSize()), 0) << "row " << y;
    }
  }
}

/// A shift of some length in one of 8 directions.
class KnownShiftInClosedForm : public ::testing::TestWithParam<std::tuple<double, int>> {};

TEST_P(KnownShiftInClosedForm, IsRecoveredToSubPixel) {
  const auto [length, direction] = GetParam();
  const double dx = length * std::cos(direction * M_PI / 4);
  const double dy = length * std::sin(direction * M_PI / 4);
  const SyntheticPair pair = ShiftedPair(kSize, dx, dy);
  for (const char* preset : {"accurate", "fast"}) {
    const WarpScore score = ScoreWarp(Estimate(Preset(preset), pair), Shift(dx, dy));
    EXPECT_LT(score.median_error_px, 0.05) << preset;
    EXPECT_GT(score.density, 0.9) << preset;
  }
  const WarpScore score = ScoreWarp(Estimate(Preset("realtime"), pair), Shift(dx, dy));
  EXPECT_LT(score.median_error_px, 0.1);
  EXPECT_GT(score.density, 0.85);
}

/// What looks like noise is matched at half size, as above; what does not, at full size.
TEST_P(KnownShiftInClosedForm, IsRecoveredAtFullSize) {
  const auto [length, direction] = GetParam();
  const double dx = length * std::cos(direction * M_PI / 4);
  const double dy = length * std::sin(direction * M_PI / 4);
  const SyntheticPair pair = CleanPair(kSize, dx, dy);
  for (const char* preset : {"accurate", "fast"}) {
    hardware::StageTimes times;
    const DisparityField field =
        V1ClosedFormEstimator(Preset(preset)).Estimate(pair.left, pair.right, &times);
    EXPECT_EQ(times.samples().count("enlarge"), 0U) << preset;
    const WarpScore score = ScoreWarp(field, Shift(dx, dy));
    EXPECT_LT(score.median_error_px, 0.05) << preset;
    EXPECT_GT(score.density, 0.9) << preset;
  }
}

INSTANTIATE_TEST_SUITE_P(V1ClosedForm, KnownShiftInClosedForm,
                         ::testing::Combine(::testing::Values(0.25, 1.3, 7.6, 20.0),
                                            ::testing::Range(0, 8)));

/// Disparities far from zero, of which nothing is known beforehand.
class FarShift : public ::testing::TestWithParam<std::tuple<int, int>> {};

TEST_P(FarShift, IsFoundAsIfItWereNear) {
  const auto [dx, dy] = GetParam();
  const cv::Size size(400, 160);
  const SyntheticPair pair = ShiftedPair(size, dx, dy);
  const WarpScore score = ScoreWarp(Estimate(Preset("accurate"), pair), Shift(dx, dy));
  EXPECT_LT(score.median_error_px, 0.05);
  EXPECT_GT(score.density, 0.85);
}

INSTANTIATE_TEST_SUITE_P(V1ClosedForm, FarShift,
                         ::testing::Combine(::testing::Values(-200, -90, 110, 200),
                                            ::testing::Values(-30, 0, 30)));

TEST(V1ClosedForm, FollowsAZoomAndARotation) {
  const double angle = 0.03, zoom = 1.04;
  const cv::Matx33d centre(1, 0, kSize.width / 2.0, 0, 1, kSize.height / 2.0, 0, 0, 1);
  const cv::Matx33d turn(zoom * std::cos(angle), -zoom * std::sin(angle), 2.5,
                         zoom * std::sin(angle), zoom * std::cos(angle), -1.2, 0, 2e-5, 1);
  const cv::Matx33d H = centre * turn * centre.inv();
  const WarpScore score = ScoreWarp(Estimate(Preset("accurate"), WarpedPair(kSize, H)), H);
  EXPECT_LT(score.median_error_px, 0.05);
  EXPECT_GT(score.density, 0.9);
}

TEST(V1ClosedForm, IsIndifferentToTheExposureOfOneEye) {
  const SyntheticPair pair = ShiftedPair(kSize, 5.4, -1.2);
  for (const double gain : {0.5, 0.8, 1.5}) {
    SyntheticPair changed = pair;
    cv::Mat1b right;
    changed.right.convertTo(right, CV_8U, gain);
    changed.right = right;
    const WarpScore score = ScoreWarp(Estimate(Preset("accurate"), changed), Shift(5.4, -1.2));
    EXPECT_LT(score.median_error_px, 0.06) << gain;
    EXPECT_GT(score.density, 0.85) << gain;
  }
}

TEST(V1ClosedForm, UnrelatedImagesMatchNowhere) {
  const SyntheticPair one = ShiftedPair(kSize, 0, 0, 1), other = ShiftedPair(kSize, 0, 0, 2);
  const DisparityField field = Estimate(Preset("accurate"), {one.left, other.right});
  EXPECT_LT(cv::countNonZero(field.valid), 0.02 * kSize.area());
}

TEST(V1ClosedForm, PlainImagesMatchNowhere) {
  const SyntheticPair plain{cv::Mat1b(kSize, 90), cv::Mat1b(kSize, 90)};
  EXPECT_EQ(cv::countNonZero(Estimate(Preset("accurate"), plain).valid), 0);
}

TEST(V1ClosedForm, EveryInstructionSetGivesTheSameBits) {
  const SyntheticPair pair = CleanPair({203, 111}, -7.3, 2.6);
  for (const char* preset : {"accurate", "dense", "fast", "realtime"}) {
    const DisparityField portable = Estimate(Preset(preset), pair, "portable");
    for (const std::string_view kernels : UsableKernels()) {
      SCOPED_TRACE(std::string(preset) + " " + std::string(kernels));
      ExpectSameBits(portable, Estimate(Preset(preset), pair, std::string(kernels)));
    }
  }
  for (const char* set : {"avx2", "avx512"}) {
    try {
      SelectKernels(set);
    } catch (const std::invalid_argument&) {
      GTEST_SKIP() << "this processor has no " << set << ": not compared";
    }
  }
}

/// All of five threads meet within one loop: the tests of threads have as many as they ask for.
TEST(OnThreads, AreAsManyAsAskedFor) {
  const auto meet = [] {
    std::atomic<int> arrived = 0;
    const auto start = std::chrono::steady_clock::now();
    tbb::parallel_for(
        0, 5,
        [&](int) {
          ++arrived;
          while (arrived < 5 && std::chrono::steady_clock::now() - start < std::chrono::seconds(30))
            std::this_thread::yield();
        },
        tbb::simple_partitioner());
    return std::chrono::steady_clock::now() - start;
  };
  EXPECT_LT(OnThreads(5, meet), std::chrono::seconds(30));
}

TEST(V1ClosedForm, IsTheSameOnAnyNumberOfThreads) {
  for (const cv::Size size : {cv::Size(321, 243), cv::Size(97, 211), cv::Size(65, 9)}) {
    const SyntheticPair pair = CleanPair(size, 9.2, 1.1);
    for (const char* preset : {"accurate", "dense", "fast", "realtime"}) {
      SCOPED_TRACE(::testing::Message() << preset << " " << size);
      const auto estimate = [&] { return Estimate(Preset(preset), pair); };
      const DisparityField one_thread = OnThreads(1, estimate);
      for (const int threads : {2, 5}) ExpectSameBits(one_thread, OnThreads(threads, estimate));
    }
  }
}

TEST(V1ClosedForm, RemembersNothingOfEarlierPairs) {
  V1ClosedFormEstimator used(Preset("accurate"));
  for (const cv::Size size : {cv::Size(160, 120), cv::Size(97, 211), cv::Size(64, 48)}) {
    const SyntheticPair pair = ShiftedPair(size, 3.5, 0.5);
    ExpectSameBits(Estimate(Preset("accurate"), pair), used.Estimate(pair.left, pair.right));
  }
}

TEST(V1ClosedForm, AnySizeGivesAField) {
  for (const char* preset : {"accurate", "realtime"}) {
    V1ClosedFormEstimator estimator(Preset(preset));
    for (const cv::Size size : {cv::Size(1, 1), cv::Size(1, 50), cv::Size(50, 1), cv::Size(2, 3),
                                cv::Size(7, 9), cv::Size(17, 16), cv::Size(33, 65)}) {
      for (const int type : {CV_8UC1, CV_8UC3}) {
        cv::Mat left(size, type), right(size, type);
        cv::RNG rng(7);
        rng.fill(left, cv::RNG::UNIFORM, 0, 256);
        rng.fill(right, cv::RNG::UNIFORM, 0, 256);
        const DisparityField field = estimator.Estimate(left, right);
        EXPECT_EQ(field.dx.size(), size) << preset;
        EXPECT_EQ(field.valid.size(), size) << preset;
      }
    }
  }
}

/// An image with too few rows for octaves is matched at full size, whatever the preset says.
TEST(V1ClosedForm, ThinImagesHaveTheSameDisparity) {
  for (const char* preset : {"accurate", "fast", "realtime"}) {
    for (const int height : {1, 2, 3, 5, 7, 9}) {
      const SyntheticPair pair = ShiftedPair({400, height}, 5, 0);
      const DisparityField field = Estimate(Preset(preset), pair);
      std::vector<float> found;
      for (int x = 0; x < 400; ++x) {
        if (field.valid(height / 2, x) != 0) found.push_back(field.dx(height / 2, x));
      }
      if (found.empty()) continue;
      std::nth_element(found.begin(), found.begin() + found.size() / 2, found.end());
      EXPECT_NEAR(found[found.size() / 2], 5, 0.3) << preset << ", height " << height;
    }
  }
}

TEST(V1ClosedForm, NoMatchLiesOutsideTheOtherImage) {
  const SyntheticPair pair = ShiftedPair({193, 145}, -6.4, 2.5);
  for (const char* preset : {"accurate", "fast", "realtime"}) {
    const DisparityField field = Estimate(Preset(preset), pair);
    int valid = 0;
    for (int y = 0; y < 145; ++y) {
      for (int x = 0; x < 193; ++x) {
        if (field.valid(y, x) == 0) continue;
        ++valid;
        const float to_x = static_cast<float>(x) + field.dx(y, x);
        const float to_y = static_cast<float>(y) + field.dy(y, x);
        EXPECT_TRUE(to_x >= 0 && to_x <= 192 && to_y >= 0 && to_y <= 144) << preset;
      }
    }
    EXPECT_GT(valid, 0.8 * 193 * 145) << preset;
  }
}

/// Noise moves the finest octave that is matched; what is left is still most of the image.
TEST(V1ClosedForm, SeesThroughNoise) {
  const SyntheticPair clean = ShiftedPair({320, 240}, 7.3, -2.1);
  cv::RNG random(11);
  for (const double sigma : {5.0, 10.0}) {
    SyntheticPair noisy;
    for (auto& [from, to] : {std::pair(&clean.left, &noisy.left), {&clean.right, &noisy.right}}) {
      cv::Mat1s noise(from->size());
      random.fill(noise, cv::RNG::NORMAL, 0, sigma);
      cv::Mat sum;
      cv::add(*from, noise, sum, cv::noArray(), CV_8U);
      *to = sum;
    }
    const WarpScore score = ScoreWarp(Estimate(Preset("accurate"), noisy), Shift(7.3, -2.1));
    EXPECT_LT(score.median_error_px, 0.2) << sigma;
    EXPECT_GT(score.density, 0.85) << sigma;
  }
}

TEST(V1ClosedForm, RefusesImagesThatWouldTakeAllMemory) {
  const cv::Mat1b huge = cv::Mat1b::zeros(8000, 8000);
  try {
    V1ClosedFormEstimator(Preset("fast")).Estimate(huge, huge);
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("8000x8000"), std::string::npos) << error.what();
  }
}

TEST(V1ClosedForm, BooksItsStages) {
  const SyntheticPair pair = ShiftedPair({64, 48}, 1, 0);
  hardware::StageTimes times;
  V1ClosedFormEstimator(Preset("fast")).Estimate(pair.left, pair.right, &times);
  EXPECT_EQ(times.samples().count("simple cells"), 1U);
  EXPECT_EQ(times.samples().count("coarse to fine"), 1U);
}

TEST(ClosedFormConfig, NamesEveryBadField) {
  ClosedFormConfig config;
  config.orientations = 5;
  config.min_coherence = 1;
  config.iterations = 0;
  const auto errors = config.Validate();
  ASSERT_EQ(errors.size(), 3U);
  EXPECT_THROW(V1ClosedFormEstimator{config}, hardware::ConfigError);
}

TEST(SelectKernels, NamesWhatThisProcessorRuns) {
  EXPECT_EQ(SelectKernels("portable").name, "portable");
  try {
    SelectKernels("neon");
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("portable"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace horopter::vision
