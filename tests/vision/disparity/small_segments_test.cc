// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/small_segments.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>

namespace horopter::vision {
namespace {

DisparityField Flat(int rows, int cols) {
  return {cv::Mat1f::zeros(rows, cols), cv::Mat1f::zeros(rows, cols), cv::Mat1f::ones(rows, cols),
          cv::Mat1b(rows, cols, uchar{255})};
}

TEST(SmallSegments, SurfaceStaysAndIslandGoes) {
  DisparityField field = Flat(20, 20);
  field.dx(cv::Rect(5, 5, 3, 3)) = 4;
  InvalidateSmallSegments(10, 1, field);
  EXPECT_EQ(cv::countNonZero(field.valid), 400 - 9);
  EXPECT_EQ(field.valid(6, 6), 0);
}

TEST(SmallSegments, SegmentOfTheSmallestSizeStays) {
  DisparityField field = Flat(20, 20);
  field.dx(cv::Rect(5, 5, 3, 3)) = 4;
  InvalidateSmallSegments(9, 1, field);
  EXPECT_EQ(cv::countNonZero(field.valid), 400);
}

TEST(SmallSegments, VerticalDisparitySeparatesToo) {
  DisparityField field = Flat(20, 20);
  field.dy(cv::Rect(0, 0, 2, 2)) = -3;
  InvalidateSmallSegments(5, 1, field);
  EXPECT_EQ(cv::countNonZero(field.valid), 400 - 4);
}

TEST(SmallSegments, SlantedSurfaceIsOneSegment) {
  DisparityField field = Flat(20, 20);
  for (int x = 0; x < 20; ++x) field.dx.col(x) = 0.9f * static_cast<float>(x);
  InvalidateSmallSegments(400, 1, field);
  EXPECT_EQ(cv::countNonZero(field.valid), 400);
}

TEST(SmallSegments, DiagonalNeighboursAreNotConnected) {
  DisparityField field = Flat(2, 2);
  field.valid = (cv::Mat1b(2, 2) << 255, 0, 0, 255);
  InvalidateSmallSegments(2, 1, field);
  EXPECT_EQ(cv::countNonZero(field.valid), 0);
}

}  // namespace
}  // namespace horopter::vision
