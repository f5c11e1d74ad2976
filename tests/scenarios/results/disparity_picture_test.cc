// SPDX-License-Identifier: Apache-2.0
#include "scenarios/results/disparity_picture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <opencv2/core.hpp>

#include "scenarios/results/colourise.h"

namespace horopter::scenarios {
namespace {

/// dx from low to high along each row; the leftmost column is invalid.
vision::DisparityField Ramp(cv::Size size, float low, float high, float dy) {
  vision::DisparityField field{cv::Mat1f(size), cv::Mat1f(size, dy), cv::Mat1f::ones(size),
                               cv::Mat1b(size, uchar{255})};
  for (int x = 0; x < size.width; ++x) {
    field.dx.col(x) = low + (high - low) * static_cast<float>(x) / (size.width - 1.0F);
  }
  for (cv::Mat1f* map : {&field.dx, &field.dy}) {
    map->col(0) = std::numeric_limits<float>::quiet_NaN();
  }
  field.valid.col(0) = 0;
  return field;
}

const cv::Size kSize(200, 40);
constexpr int kLeft = 8, kTop = 22;  // where the map lies in its panel

TEST(DisparityPicture, VerticalPartGetsAPanelOfItsOwnWhereThereIsAny) {
  const cv::Mat3b one = DisparityPicture(Ramp(kSize, -10, -2, 0));
  const cv::Mat3b two = DisparityPicture(Ramp(kSize, -10, -2, 3));
  EXPECT_EQ(two.size(), cv::Size(2 * one.cols, one.rows));
  EXPECT_EQ(cv::norm(two.colRange(0, one.cols), one, cv::NORM_INF), 0);
  EXPECT_GT(one.rows, kSize.height + kTop) << "title and scale have room";
}

TEST(DisparityPicture, OneSignIsSequentialAndBothAreWhiteAtZero) {
  const int middle = kTop + kSize.height / 2;
  const cv::Mat3b one_sign = DisparityPicture(Ramp(kSize, -10, -2, 0));
  EXPECT_EQ(one_sign(middle, kLeft + 1), MapColour(ColourMap::kRange, 0));
  EXPECT_EQ(one_sign(middle, kLeft + kSize.width - 1), MapColour(ColourMap::kRange, 1));
  const cv::Mat3b both = DisparityPicture(Ramp(kSize, -10, 10, 0));
  EXPECT_EQ(both(middle, kLeft + 1), MapColour(ColourMap::kDisparity, 0));
  const cv::Vec3b zero = both(middle, kLeft + kSize.width / 2);
  for (int c = 0; c < 3; ++c) EXPECT_GT(zero[c], 225);
}

TEST(DisparityPicture, InvalidPixelsAreGreyAndNothingValidIsNoError) {
  const cv::Mat3b picture = DisparityPicture(Ramp(kSize, -10, -2, 0));
  const cv::Vec3b invalid = picture(kTop + 3, kLeft);
  EXPECT_LT(std::abs(invalid[0] - invalid[2]), 10);
  EXPECT_LT(invalid[0], 100);
  vision::DisparityField none = Ramp(kSize, -10, -2, 1);
  none.valid = 0;
  const cv::Mat3b empty = DisparityPicture(none);
  EXPECT_LT(empty(kTop + 10, kLeft + 50)[0], 100);
  EXPECT_FALSE(DisparityPicture(Ramp({3, 3}, 0, 0, 0)).empty()) << "smaller than its legend";
}

}  // namespace
}  // namespace horopter::scenarios
