// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/enlarge_field.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>

namespace horopter::vision {
namespace {

DisparityField Plane(cv::Size size) {
  DisparityField field{cv::Mat1f(size), cv::Mat1f(size), cv::Mat1f(size, 0.5F),
                       cv::Mat1b(size, std::uint8_t{255})};
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      field.dx(y, x) = 3 + 0.1F * static_cast<float>(x);
      field.dy(y, x) = -1 + 0.05F * static_cast<float>(y);
    }
  }
  return field;
}

TEST(DoubleField, APlaneStaysOne) {
  for (const cv::Size size : {cv::Size(20, 14), cv::Size(19, 13)}) {
    DisparityField field = Plane({10, 7});
    DoubleField(cv::Mat1b(size, std::uint8_t{90}), field);
    ASSERT_EQ(field.dx.size(), size);
    for (int y = 0; y < 13; ++y) {
      for (int x = 0; x < 19; ++x) {
        EXPECT_NEAR(field.dx(y, x), 6 + 0.1 * x, 1e-5);
        EXPECT_NEAR(field.dy(y, x), -2 + 0.05 * y, 1e-5);
        EXPECT_EQ(field.confidence(y, x), 0.5F);
      }
    }
  }
}

/// Two surfaces that meet between coarse columns 4 and 5; the image says where.
TEST(DoubleField, AnEdgeOfDisparityFollowsTheImages) {
  for (const int edge : {9, 10}) {
    DisparityField field = Plane({10, 8});
    field.dx.colRange(0, 5) = 2;
    field.dx.colRange(5, 10) = 20;
    cv::Mat3b image(16, 20, cv::Vec3b(30, 40, 50));
    image.colRange(edge, 20) = cv::Scalar(200, 150, 100);
    DoubleField(image, field);
    for (int y = 0; y < 16; ++y) {
      for (int x = 0; x < 20; ++x) EXPECT_EQ(field.dx(y, x), x < edge ? 4 : 40) << x;
    }
  }
}

TEST(DoubleField, WhatIsInvalidTouchesNothing) {
  DisparityField field = Plane({10, 8});
  field.valid.colRange(5, 10) = 0;
  field.dx.colRange(5, 10) = 1e4F;
  cv::Mat1b image(16, 20, std::uint8_t{90});
  image.colRange(9, 20) = 200;
  DoubleField(image, field);
  for (int x = 0; x < 20; ++x) {
    EXPECT_EQ(field.valid(5, x), x < 9 ? 255 : 0) << x;
    if (x < 9) EXPECT_LT(field.dx(5, x), 10);
  }
}

TEST(DoubleField, ASinglePixelFillsTwoRowsOrColumns) {
  DisparityField field = Plane({1, 1});
  DoubleField(cv::Mat1b(1, 2, std::uint8_t{9}), field);
  EXPECT_EQ(field.dx(0, 0), 6);
  EXPECT_EQ(field.dx(0, 1), 6);
}

}  // namespace
}  // namespace horopter::vision
