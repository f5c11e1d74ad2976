// SPDX-License-Identifier: Apache-2.0
#include "sim/camera/motion_comb.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>

namespace horopter::sim {
namespace {

TEST(MotionComb, APointBecomesAsManyAsThereAreTapsBackAlongTheMotion) {
  cv::Mat3b view(40, 60, cv::Vec3b(0, 0, 0));
  view(20, 30) = {200, 200, 200};
  MotionComb comb;
  comb.Make(view, {1.4, -0.6}, 3);
  ASSERT_EQ(comb.levels(), 3);
  // Steps of (1, -1) and then of (3, -1): a tap shows at p what lies a step further on.
  EXPECT_EQ(comb.Extent(2), Eigen::Vector2d(4, -2));
  cv::Mat3b expected(40, 60, cv::Vec3b(0, 0, 0));
  for (const cv::Point tap : {cv::Point(0, 0), {1, -1}, {3, -1}, {4, -2}}) {
    expected(20 - tap.y, 30 - tap.x) = {50, 50, 50};
  }
  EXPECT_EQ(cv::norm(comb.image(2), expected, cv::NORM_INF), 0);
}

TEST(MotionComb, VarianceIsThatOfTheTapsPlaces) {
  MotionComb comb;
  comb.Make(cv::Mat3b(10, 10, cv::Vec3b(0, 0, 0)), {1.5, 0.7}, 3);
  const Eigen::Vector2d first(2, 1), second(3, 1);
  const Eigen::Vector2d mean = (first + second) / 2;
  double variance = 0;
  for (const Eigen::Vector2d& tap :
       {Eigen::Vector2d(0, 0), first, second, Eigen::Vector2d(first + second)}) {
    variance += (tap - mean).squaredNorm() / 4;
  }
  EXPECT_DOUBLE_EQ(comb.Variance(2), variance);
}

TEST(MotionComb, KeepsTheMeanBrightnessOfNoise) {
  cv::Mat3b view(200, 300);
  cv::RNG random(5);
  random.fill(view, cv::RNG::UNIFORM, 0, 256);
  MotionComb comb;
  comb.Make(view, {1.5, 0}, 3);
  EXPECT_NEAR(cv::mean(comb.image(2))[0], cv::mean(view)[0], 0.3);
}

TEST(MotionComb, KeepsAnEvenImageEvenUpToItsBorder) {
  const cv::Mat3b view(30, 40, cv::Vec3b(91, 90, 89));
  MotionComb comb;
  comb.Make(view, {-1.1, 1.3}, 3);
  EXPECT_EQ(cv::norm(comb.image(2), view, cv::NORM_INF), 0);
}

}  // namespace
}  // namespace horopter::sim
