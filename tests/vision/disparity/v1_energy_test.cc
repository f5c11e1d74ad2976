// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/v1_energy.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>

#include "textured_pair.h"

namespace horopter::vision {
namespace {

using testing::ScoreWarp;
using testing::ShiftedPair;
using testing::SyntheticPair;
using testing::WarpedPair;
using testing::WarpScore;

const cv::Size kSize(192, 144);

V1EnergyEstimator Preset(const char* name) { return V1EnergyEstimator(V1Config::Preset(name)); }

cv::Matx33d Shift(double dx, double dy) { return {1, 0, dx, 0, 1, dy, 0, 0, 1}; }

/// A shift of some length in one of 8 directions.
class KnownShift : public ::testing::TestWithParam<std::tuple<double, int>> {};

TEST_P(KnownShift, IsRecoveredToSubPixel) {
  const auto [length, direction] = GetParam();
  const double dx = length * std::cos(direction * M_PI / 4);
  const double dy = length * std::sin(direction * M_PI / 4);
  const SyntheticPair pair = ShiftedPair(kSize, dx, dy);

  const WarpScore checked =
      ScoreWarp(Preset("checked").Estimate(pair.left, pair.right), Shift(dx, dy));
  EXPECT_LT(checked.median_error_px, 0.05);
  EXPECT_GT(checked.density, 0.85);

  const WarpScore paper =
      ScoreWarp(Preset("paper_2009").Estimate(pair.left, pair.right), Shift(dx, dy));
  // The hard threshold moves the centre of mass in steps of the phase grid.
  EXPECT_LT(paper.median_error_px, 0.12);
  EXPECT_GT(paper.density, 0.85);
}

TEST_P(KnownShift, IsRecoveredByTheModelOf2018) {
  const auto [length, direction] = GetParam();
  const double dx = length * std::cos(direction * M_PI / 4);
  const double dy = length * std::sin(direction * M_PI / 4);
  const SyntheticPair pair = ShiftedPair(kSize, dx, dy);
  const DisparityField field = Preset("paper_2018").Estimate(pair.left, pair.right);
  const WarpScore score = ScoreWarp(field, Shift(dx, dy));
  EXPECT_LT(score.median_error_px, 0.1);
  EXPECT_EQ(score.density, 1);
}

INSTANTIATE_TEST_SUITE_P(V1Energy, KnownShift,
                         ::testing::Combine(::testing::Values(0.25, 1.3, 7.6, 20.0),
                                            ::testing::Range(0, 8)));

TEST(V1Energy, EveryOctaveDoublesTheReach) {
  // +-1.5 (2^n - 1) px: 1.5, 4.5, 10.5, 22.5.
  for (int scales = 1; scales <= 4; ++scales) {
    V1Config config;
    config.scales = scales;
    const double reach = config.max_disparity_px * (std::pow(2, scales) - 1);
    V1EnergyEstimator estimator(config);

    const SyntheticPair within = ShiftedPair(kSize, 0.7 * reach, 0);
    const WarpScore found =
        ScoreWarp(estimator.Estimate(within.left, within.right), Shift(0.7 * reach, 0));
    EXPECT_GT(found.density, 0.8) << scales << " scales";
    EXPECT_LT(found.median_error_px, 0.1) << scales << " scales";

    // What lies beyond the reach cannot be found, and must not be claimed.
    const double beyond = 2 * config.iterations * reach + 4;
    const SyntheticPair outside = ShiftedPair(kSize, beyond, 0);
    const WarpScore lost =
        ScoreWarp(estimator.Estimate(outside.left, outside.right), Shift(beyond, 0));
    EXPECT_LT(lost.density, 0.3) << scales << " scales";
  }
}

TEST(V1Energy, HalfOctavesReachTheSumOfTheirLevels) {
  // +-0.76 times 1, 2.4, 4.4, 7.2, 11.2, .. px; the coarser levels begin where finer ones end.
  for (int scales = 1; scales <= 7; ++scales) {
    V1Config config = V1Config::Preset("paper_2018");
    config.scales = scales;
    config.fill_in = false;
    config.min_pooled = 0.5;
    double reach = 0;
    for (int k = 0; k < scales; ++k) reach += config.max_disparity_px * std::pow(M_SQRT2, k);
    for (const int direction : {0, 3, 4, 6}) {
      const double dx = 0.7 * reach * std::cos(direction * M_PI / 4);
      const double dy = 0.7 * reach * std::sin(direction * M_PI / 4);
      const SyntheticPair pair = ShiftedPair(kSize, dx, dy);
      const WarpScore score =
          ScoreWarp(V1EnergyEstimator(config).Estimate(pair.left, pair.right), Shift(dx, dy));
      EXPECT_LT(score.median_error_px, 0.25) << scales << " scales, direction " << direction;
      EXPECT_GT(score.density, 0.9) << scales << " scales, direction " << direction;
    }
  }
}

TEST(V1Energy, OctavesAndHalfOctavesAgreeOnADecoding) {
  // The centre of mass over half octaves, and the linear readout over octaves.
  const SyntheticPair pair = ShiftedPair(kSize, -6.3, 2.1);
  V1Config config;
  config.pyramid = PyramidStep::kHalfOctave;
  config.scales = 9;
  const WarpScore half =
      ScoreWarp(V1EnergyEstimator(config).Estimate(pair.left, pair.right), Shift(-6.3, 2.1));
  EXPECT_LT(half.median_error_px, 0.05);
  EXPECT_GT(half.density, 0.85);

  config = V1Config();
  config.decoding = V1Decoding::kLinear;
  config.max_disparity_px = 1;
  const WarpScore linear =
      ScoreWarp(V1EnergyEstimator(config).Estimate(pair.left, pair.right), Shift(-6.3, 2.1));
  EXPECT_LT(linear.median_error_px, 0.05);
  EXPECT_GT(linear.density, 0.85);
}

TEST(V1Energy, NormalisedInputForgivesOneEyesLightAndContrast) {
  const SyntheticPair pair = ShiftedPair(kSize, 4.4, -1.2);
  cv::Mat1b dim;
  pair.right.convertTo(dim, CV_8U, 0.5, 30);
  const WarpScore score =
      ScoreWarp(Preset("paper_2018").Estimate(pair.left, dim), Shift(4.4, -1.2));
  EXPECT_LT(score.median_error_px, 0.1);
}

TEST(V1Energy, FillInMarksWhatNobodySaw) {
  // Plain ground right of x = 96: what lies there is filled in from the texture beside it.
  SyntheticPair pair = ShiftedPair(kSize, -3.3, 0);
  pair.left.colRange(96, kSize.width).setTo(120);
  pair.right.colRange(93, kSize.width).setTo(120);
  V1Config config;
  config.fill_in = true;
  const DisparityField field = V1EnergyEstimator(config).Estimate(pair.left, pair.right);
  config.fill_in = false;
  const DisparityField seen = V1EnergyEstimator(config).Estimate(pair.left, pair.right);
  EXPECT_TRUE(seen.filled.empty());
  ASSERT_EQ(cv::countNonZero(field.valid), static_cast<int>(field.valid.total()));
  EXPECT_EQ(cv::countNonZero(field.filled.colRange(96 + 36, kSize.width) == 0), 0);
  EXPECT_LT(cv::countNonZero(field.filled.colRange(8, 88)), 0.1 * 80 * kSize.height);
  EXPECT_NEAR(field.dx(72, 150), -3.3, 0.3);
  EXPECT_NEAR(field.dy(72, 150), 0, 0.3);
  EXPECT_EQ(cv::norm(field.confidence, cv::NORM_INF, field.filled), 0);
}

TEST(V1Energy, FollowsAZoomAndARotation) {
  const double angle = 0.03;
  const double zoom = 1.04;
  const cv::Matx33d centre(1, 0, kSize.width / 2.0, 0, 1, kSize.height / 2.0, 0, 0, 1);
  const cv::Matx33d turn(zoom * std::cos(angle), -zoom * std::sin(angle), 2.5,
                         zoom * std::sin(angle), zoom * std::cos(angle), -1.2, 0, 2e-5, 1);
  const cv::Matx33d H = centre * turn * centre.inv();
  const SyntheticPair pair = WarpedPair(kSize, H);
  const WarpScore checked = ScoreWarp(Preset("checked").Estimate(pair.left, pair.right), H);
  EXPECT_LT(checked.median_error_px, 0.06);
  EXPECT_GT(checked.density, 0.9);
  for (const char* preset : {"paper_2009", "paper_2018"}) {
    const WarpScore paper = ScoreWarp(Preset(preset).Estimate(pair.left, pair.right), H);
    EXPECT_LT(paper.median_error_px, 0.12) << preset;
  }
}

TEST(V1Energy, ConfidenceIsLowerWhereTheEyesSeeDifferentThings) {
  const SyntheticPair pair = ShiftedPair(kSize, 3.2, 0);
  cv::Mat1b right = pair.right.clone();
  testing::SyntheticPair other = ShiftedPair(kSize, 0, 0, 77);
  other.right.rowRange(72, 144).copyTo(right.rowRange(72, 144));
  V1Config config;
  config.left_right_px = 0;
  config.min_correlation = -1;
  const DisparityField field = V1EnergyEstimator(config).Estimate(pair.left, right);
  const double same = cv::mean(field.confidence.rowRange(10, 62))[0];
  const double different = cv::mean(field.confidence.rowRange(82, 134))[0];
  EXPECT_GT(same, 0.8);
  EXPECT_LT(different, 0.5 * same);
}

TEST(V1Energy, PlainImagesHaveNoValidPixel) {
  for (const char* preset : {"checked", "paper_2009", "paper_2018"}) {
    for (const int grey : {0, 120, 255}) {
      const cv::Mat1b plain(kSize, static_cast<unsigned char>(grey));
      EXPECT_EQ(cv::countNonZero(Preset(preset).Estimate(plain, plain).valid), 0) << preset;
    }
  }
}

/// Texture left of x = 96, a plain wall right of it, and both eyes' sensor noise.
SyntheticPair HalfPlain(double noise_grey) {
  SyntheticPair pair = ShiftedPair(kSize, -3.3, 0);
  pair.left.colRange(96, kSize.width).setTo(120);
  pair.right.colRange(93, kSize.width).setTo(120);
  cv::RNG rng(5);
  for (cv::Mat1b* image : {&pair.left, &pair.right}) {
    cv::Mat1f noise(kSize), noisy;
    rng.fill(noise, cv::RNG::NORMAL, 0, noise_grey);
    cv::add(*image, noise, noisy, cv::noArray(), CV_32F);
    noisy.convertTo(*image, CV_8U);
  }
  return pair;
}

double ShareValid(const DisparityField& field, int from_column, int to_column) {
  const cv::Mat1b part = field.valid.colRange(from_column, to_column);
  return cv::countNonZero(part) / static_cast<double>(part.total());
}

TEST(V1Energy, InteriorOfAPlainHalfIsInvalid) {
  const SyntheticPair pair = HalfPlain(0);
  const DisparityField field = Preset("checked").Estimate(pair.left, pair.right);
  EXPECT_GT(ShareValid(field, 8, 88), 0.9);
  // An estimate is kept over two octaves: filters of 11 px there reach 5 * 4 px, plus pooling.
  EXPECT_EQ(ShareValid(field, 96 + 36, kSize.width), 0);
}

TEST(V1Energy, SensorNoiseOnAPlainWallIsNotTexture) {
  for (const double noise : {1.0, 3.0}) {
    const SyntheticPair pair = HalfPlain(noise);
    V1Config config;
    config.noise_grey = noise;
    const DisparityField field = V1EnergyEstimator(config).Estimate(pair.left, pair.right);
    EXPECT_GT(ShareValid(field, 8, 88), 0.9) << "noise " << noise;
    EXPECT_LT(ShareValid(field, 96 + 36, kSize.width), 0.01) << "noise " << noise;
  }
}

TEST(V1Energy, LeftRightCheckRemovesHalfOccludedPixels) {
  // A square 12 px nearer than its background: to its left the right eye does not see the ground.
  SyntheticPair pair = ShiftedPair(kSize, 0, 0);
  const SyntheticPair front = ShiftedPair(kSize, -12, 0, 9);
  const cv::Rect square(90, 50, 70, 70);
  front.left(square).copyTo(pair.left(square));
  front.right(square - cv::Point(12, 0)).copyTo(pair.right(square - cv::Point(12, 0)));
  const cv::Rect occluded(80, 60, 8, 50);
  V1Config config;
  const DisparityField checked = V1EnergyEstimator(config).Estimate(pair.left, pair.right);
  config.left_right_px = 0;
  const DisparityField unchecked = V1EnergyEstimator(config).Estimate(pair.left, pair.right);
  EXPECT_LT(cv::countNonZero(checked.valid(occluded)),
            0.5 * cv::countNonZero(unchecked.valid(occluded)));
  EXPECT_NEAR(checked.dx(85, 125), -12, 0.2);
  EXPECT_NEAR(checked.dx(85, 30), 0, 0.2);
}

TEST(V1Energy, AnySizeIsAccepted) {
  const SyntheticPair pair = ShiftedPair({97, 61}, 1, 0);
  for (const cv::Size size : {cv::Size(1, 1), cv::Size(3, 5), cv::Size(1, 40), cv::Size(40, 1),
                              cv::Size(17, 9), cv::Size(97, 61)}) {
    const cv::Rect part(cv::Point(0, 0), size);
    for (const char* preset : {"checked", "paper_2009", "paper_2018"}) {
      const DisparityField field = Preset(preset).Estimate(pair.left(part), pair.right(part));
      EXPECT_EQ(field.dx.size(), size);
      EXPECT_EQ(field.dy.size(), size);
      EXPECT_EQ(field.confidence.size(), size);
      EXPECT_EQ(field.valid.size(), size);
    }
  }
}

TEST(V1Energy, CautiousIsPreciseAndLosesLittleButTheBorder) {
  const V1Config config = V1Config::Preset("cautious");
  const SyntheticPair pair = ShiftedPair({320, 240}, -5, 1.5);
  const DisparityField field = V1EnergyEstimator(config).Estimate(pair.left, pair.right);
  const WarpScore score = ScoreWarp(field, Shift(-5, 1.5));
  EXPECT_LT(score.median_error_px, 0.05);
  const cv::Rect interior(config.border_px + 5, config.border_px, 320 - 2 * config.border_px - 5,
                          240 - 2 * config.border_px - 2);
  EXPECT_GT(cv::countNonZero(field.valid(interior)), 0.9 * interior.area());
  EXPECT_EQ(cv::countNonZero(field.valid.colRange(0, config.border_px)), 0);
  EXPECT_EQ(cv::countNonZero(field.valid.rowRange(0, config.border_px)), 0);
}

}  // namespace
}  // namespace horopter::vision
