// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/pyramid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <opencv2/core.hpp>
#include <vector>

namespace horopter::vision {
namespace {

cv::Mat1f RampX(cv::Size size, float slope) {
  cv::Mat1f ramp(size);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) ramp(y, x) = slope * static_cast<float>(x);
  }
  return ramp;
}

TEST(Pyramid, PixelOfAnOctaveLiesOnEverySecondPixel) {
  const auto octaves = BuildPyramid(RampX({41, 33}, 1), 2, 1);
  ASSERT_EQ(octaves.size(), 2U);
  EXPECT_EQ(octaves[1].size(), cv::Size(21, 17));
  for (int x = 2; x < 19; ++x) EXPECT_NEAR(octaves[1](8, x), 2 * x, 1e-4);
}

TEST(Pyramid, StopsBeforeTheSmallestSide) {
  const cv::Mat1f image(240, 320, 0.0F);
  EXPECT_EQ(BuildPyramid(image, 12, 8).size(), 6U);  // down to 10x8
  EXPECT_EQ(BuildPyramid(image, 3, 8).size(), 3U);
  EXPECT_EQ(BuildPyramid(cv::Mat1f(1, 1, 0.0F), 6, 8).size(), 1U);
}

TEST(Pyramid, UpsamplingDoublesDisparityAndKeepsItsPlace) {
  // dx = 0.1 x at full size is 0.1 x in every octave.
  const cv::Mat1f fine = UpsampleDisparity(RampX({21, 17}, 0.1F), {41, 33});
  for (int x = 0; x <= 40; ++x) EXPECT_NEAR(fine(10, x), 0.1 * x, 1e-4) << x;
}

TEST(Pyramid, NearestUpsamplingKeepsValues) {
  const cv::Mat1b coarse = (cv::Mat1b(1, 3) << 5, 0, 7);
  const cv::Mat1b fine = UpsampleNearest(coarse, {6, 2});
  EXPECT_EQ(fine(0, 0), 5);
  EXPECT_EQ(fine(0, 2), 0);
  EXPECT_EQ(fine(1, 4), 7);
  EXPECT_EQ(fine(1, 5), 7);
}

constexpr PyramidStep kHalf = PyramidStep::kHalfOctave;

TEST(Pyramid, HalfOctavesAreSmallerByTheSquareRootOfTwo) {
  const auto levels = BuildPyramid(cv::Mat1f(300, 200, 0.0F), 9, 8, kHalf);
  ASSERT_EQ(levels.size(), 9U);
  const std::vector<int> widths = {200, 141, 99, 70, 49, 34, 24, 17, 12};
  const std::vector<int> heights = {300, 212, 150, 106, 75, 53, 37, 26, 18};
  for (std::size_t k = 0; k < 9; ++k) EXPECT_EQ(levels[k].size(), cv::Size(widths[k], heights[k]));
  EXPECT_EQ(BuildPyramid(cv::Mat1f(300, 200, 0.0F), 20, 8, kHalf).size(), 10U);  // down to 8x12
  EXPECT_EQ(BuildPyramid(cv::Mat1f(1, 1, 0.0F), 9, 1, kHalf).size(), 1U);
  EXPECT_EQ(BuildPyramid(cv::Mat1f(2, 3, 0.0F), 9, 1, kHalf).back().size(), cv::Size(1, 1));
}

TEST(Pyramid, PixelOfAHalfOctaveLiesOnItsPlaceInTheOneBefore) {
  // A linear ramp stays one under a symmetric filter; between pixels under an uneven one it is off
  // by the filter's own centre of gravity, less than a tenth of a pixel.
  const auto levels = BuildPyramid(RampX({80, 60}, 1), 5, 1, kHalf);
  for (std::size_t k = 1; k < levels.size(); ++k) {
    const double factor = std::pow(std::numbers::sqrt2, static_cast<double>(k));
    for (int x = 3; x < levels[k].cols - 3; ++x) {
      EXPECT_NEAR(levels[k](levels[k].rows / 2, x), factor * x, 0.1 * factor) << k << " " << x;
    }
  }
}

TEST(Pyramid, HalfOctavesHoldBackWhatTheyCannotShow) {
  // A wave of 0.45 cycles/px would be one of 0.36 cycles per coarse pixel, mirrored.
  cv::Mat1f wave(64, 64), slow(64, 64);
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      wave(y, x) = static_cast<float>(std::cos(2 * CV_PI * 0.45 * x));
      slow(y, x) = static_cast<float>(std::cos(2 * CV_PI * 0.05 * x));
    }
  }
  const auto deviation = [](const cv::Mat1f& image) {
    cv::Scalar mean, sigma;
    cv::meanStdDev(image(cv::Rect(4, 4, 36, 36)), mean, sigma);
    return sigma[0];
  };
  EXPECT_LT(deviation(BuildPyramid(wave, 2, 1, kHalf)[1]), 0.25);
  EXPECT_GT(deviation(BuildPyramid(slow, 2, 1, kHalf)[1]), 0.65);
}

TEST(Pyramid, AShiftIsCarriedOverHalfOctaves) {
  // 0.1 x at full size is 0.1 x at every level, and a constant shift of 8 px is 8 / factor.
  cv::Mat1f slope = RampX({57, 43}, 0.1F), shift(18, 20, 1.0F);
  cv::Mat1f fine = UpsampleDisparity(slope, {80, 60}, kHalf);
  for (int x = 0; x < 79; ++x) EXPECT_NEAR(fine(20, x), 0.1 * x, 0.005) << x;
  const std::vector<cv::Size> sizes = {{28, 25}, {40, 36}, {56, 50}, {80, 71}};
  for (const cv::Size& size : sizes) shift = UpsampleDisparity(shift, size, kHalf);
  EXPECT_NEAR(shift(0, 0), 4, 1e-4);
  EXPECT_NEAR(shift(70, 79), 4, 1e-4);
}

TEST(Pyramid, NearestUpsamplingOfHalfOctavesKeepsValues) {
  const cv::Mat1b coarse = (cv::Mat1b(1, 3) << 5, 0, 7);
  const cv::Mat1b fine = UpsampleNearest(coarse, {4, 1}, kHalf);
  EXPECT_EQ(fine(0, 0), 5);
  EXPECT_EQ(fine(0, 1), 0);  // at 0.7
  EXPECT_EQ(fine(0, 3), 7);  // at 2.1
}

}  // namespace
}  // namespace horopter::vision
