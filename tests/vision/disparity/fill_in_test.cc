// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/fill_in.h"

#include <gtest/gtest.h>

#include <limits>
#include <opencv2/core.hpp>

namespace horopter::vision {
namespace {

const cv::Size kSize(60, 40);

/// dx = -12 on the left half, which is dark, and -3 on the right, which is bright.
struct Step {
  cv::Mat1b guide{kSize, 40};
  DisparityField field{cv::Mat1f(kSize, -12),
                       cv::Mat1f(kSize, 0.5F),
                       cv::Mat1f(kSize, 0.9F),
                       cv::Mat1b(kSize, 255),
                       {}};
  Step() {
    const cv::Rect right(30, 0, 30, 40);
    guide(right) = 200;
    field.dx(right) = -3;
  }
  void Invalidate(const cv::Rect& where) {
    field.valid(where) = 0;
    field.dx(where) = std::numeric_limits<float>::quiet_NaN();
    field.dy(where) = std::numeric_limits<float>::quiet_NaN();
    field.confidence(where) = 0;
  }
};

TEST(FillIn, TakesTheDisparityOfTheSameColour) {
  Step step;
  step.Invalidate({22, 10, 16, 12});  // across the edge
  FillIn(step.guide, {}, step.field);
  EXPECT_EQ(cv::countNonZero(step.field.valid), kSize.area());
  EXPECT_EQ(cv::countNonZero(step.field.filled), 16 * 12);
  for (int x = 22; x < 38; ++x) {
    EXPECT_NEAR(step.field.dx(15, x), x < 30 ? -12 : -3, 0.1) << x;
    EXPECT_NEAR(step.field.dy(15, x), 0.5, 1e-4);
    EXPECT_EQ(step.field.confidence(15, x), 0);
  }
}

TEST(FillIn, LeavesMatchedPixelsAsTheyAre) {
  Step step;
  step.field.dx(5, 5) = -11.25F;
  step.Invalidate({10, 10, 5, 5});
  FillIn(step.guide, {}, step.field);
  EXPECT_EQ(step.field.dx(5, 5), -11.25F);
  EXPECT_EQ(step.field.confidence(5, 5), 0.9F);
  EXPECT_EQ(step.field.filled(5, 5), 0);
}

TEST(FillIn, HasNothingToFillWithWhereNothingIsValid) {
  Step step;
  step.Invalidate({0, 0, kSize.width, kSize.height});
  FillIn(step.guide, {}, step.field);
  EXPECT_EQ(cv::countNonZero(step.field.valid), 0);
  EXPECT_EQ(cv::countNonZero(step.field.filled), 0);
}

}  // namespace
}  // namespace horopter::vision
