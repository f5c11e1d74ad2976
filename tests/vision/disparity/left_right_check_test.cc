// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/left_right_check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>

#include "on_threads.h"

namespace horopter::vision {
namespace {

DisparityField Uniform(cv::Size size, float dx, float dy) {
  return {cv::Mat1f(size, dx), cv::Mat1f(size, dy), cv::Mat1f(size, 1.0F),
          cv::Mat1b(size, static_cast<unsigned char>(255))};
}

TEST(LeftRightCheck, KeepsWhatLeadsBackAndDropsWhatDoesNot) {
  const cv::Size size(20, 10);
  DisparityField field = Uniform(size, 3, -1);
  DisparityField back = Uniform(size, -3.5F, 1.5F);
  back.dx(4, 8) = -5;     // misses left pixel (5, 5) by 2 px
  back.valid(6, 12) = 0;  // nothing is known where left pixel (9, 7) goes
  CheckLeftRight(back, 1, field);
  EXPECT_EQ(field.valid(5, 6), 255);
  EXPECT_EQ(field.valid(5, 5), 0);
  EXPECT_EQ(field.valid(7, 9), 0);
  EXPECT_EQ(field.valid(5, 17), 0) << "its match lies right of the image";
  EXPECT_EQ(field.valid(0, 5), 0) << "its match lies above the image";
}

TEST(LeftRightCheck, DistanceIsOfTheVector) {
  DisparityField field = Uniform({5, 5}, 0, 0);
  CheckLeftRight(Uniform({5, 5}, 0.8F, 0.8F), 1, field);
  EXPECT_EQ(field.valid(2, 2), 0);
  field = Uniform({5, 5}, 0, 0);
  CheckLeftRight(Uniform({5, 5}, 0.7F, 0.7F), 1, field);
  EXPECT_EQ(field.valid(2, 2), 255);
}

TEST(InvalidateOutside, KeepsMatchesUpToTheLastPixelCentre) {
  DisparityField field = Uniform({5, 3}, 2, 0);
  InvalidateOutside(field);
  EXPECT_EQ(field.valid(1, 2), 255);
  EXPECT_EQ(field.valid(1, 3), 0);
}

TEST(InvalidateOutside, BorderCountsInBothImages) {
  DisparityField field = Uniform({20, 10}, 2, 0);
  InvalidateOutside(field, 3);
  EXPECT_EQ(field.valid(5, 2), 0);  // too near to the left image's border
  EXPECT_EQ(field.valid(5, 3), 255);
  EXPECT_EQ(field.valid(5, 14), 255);
  EXPECT_EQ(field.valid(5, 15), 0);  // its match is too near to the right image's
  EXPECT_EQ(field.valid(2, 8), 0);
  EXPECT_EQ(field.valid(7, 8), 0);
}

/// More rows than a block has, on one thread and on five, against the definition.
TEST(LeftRightCheck, EveryRowIsCheckedOnAnyNumberOfThreads) {
  const cv::Size size(65, 203);
  cv::RNG random(31);
  DisparityField field = Uniform(size, 0, 0), back = Uniform(size, 0, 0);
  for (cv::Mat1f* map : {&field.dx, &field.dy, &back.dx, &back.dy}) {
    random.fill(*map, cv::RNG::UNIFORM, -3, 3);
  }
  random.fill(back.valid, cv::RNG::UNIFORM, 0, 2);
  const auto expected = [&](int x, int y) {
    const float to_x = static_cast<float>(x) + field.dx(y, x);
    const float to_y = static_cast<float>(y) + field.dy(y, x);
    if (to_x < 0 || to_y < 0 || to_x > 64 || to_y > 202) return false;
    const cv::Point match(cvRound(to_x), cvRound(to_y));
    return back.valid(match) != 0 &&
           std::hypot(field.dx(y, x) + back.dx(match), field.dy(y, x) + back.dy(match)) <= 1.5F;
  };
  for (const int threads : {1, 5}) {
    DisparityField checked = field;
    checked.valid = field.valid.clone();
    testing::OnThreads(threads, [&] {
      InvalidateOutside(checked);
      CheckLeftRight(back, 1.5, checked);
    });
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        ASSERT_EQ(checked.valid(y, x) != 0, expected(x, y)) << x << " " << y;
      }
    }
    EXPECT_GT(cv::countNonZero(checked.valid), 900);
  }
}

TEST(InvalidateOutside, DropsWhatHasNoMatch) {
  DisparityField field = Uniform({20, 70}, 1, 1);
  field.dx(40, 7) = std::nanf("");
  field.dy(41, 7) = std::nanf("");
  InvalidateOutside(field);
  EXPECT_EQ(field.valid(40, 7), 0);
  EXPECT_EQ(field.valid(41, 7), 0);
  EXPECT_EQ(cv::countNonZero(field.valid), 19 * 69 - 2);
}

TEST(BlankInvalid, WritesNaNExactlyWhereInvalid) {
  DisparityField field = Uniform({4, 4}, 1, 2);
  field.valid(1, 2) = 0;
  BlankInvalid(field);
  EXPECT_TRUE(std::isnan(field.dx(1, 2)) && std::isnan(field.dy(1, 2)));
  EXPECT_EQ(field.confidence(1, 2), 0);
  EXPECT_EQ(field.dx(0, 0), 1);
  EXPECT_EQ(field.dy(0, 0), 2);
}

}  // namespace
}  // namespace horopter::vision
