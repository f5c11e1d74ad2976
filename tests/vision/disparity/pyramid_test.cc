// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/pyramid.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace horopter::vision
