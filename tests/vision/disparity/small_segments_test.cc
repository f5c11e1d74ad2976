// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/small_segments.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <vector>

#include "on_threads.h"

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

/// Segments as the header defines them, grown from each pixel in turn.
cv::Mat1b KeptByFloodFill(int min_px, float max_step_px, const DisparityField& field) {
  cv::Mat1b kept = field.valid.clone(), seen = field.valid == 0;
  const cv::Rect image({}, kept.size());
  std::vector<cv::Point> segment;
  for (int i = 0; i < image.area(); ++i) {
    const cv::Point seed(i % image.width, i / image.width);
    if (seen(seed) != 0) continue;
    segment.assign(1, seed);
    seen(seed) = 255;
    for (std::size_t next = 0; next < segment.size(); ++next) {
      const cv::Point from = segment[next];
      for (const cv::Point step : {cv::Point(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
        const cv::Point to = from + step;
        if (!image.contains(to) || seen(to) != 0) continue;
        const float dx = field.dx(to) - field.dx(from), dy = field.dy(to) - field.dy(from);
        if (dx * dx + dy * dy > max_step_px * max_step_px) continue;
        seen(to) = 255;
        segment.push_back(to);
      }
    }
    if (static_cast<int>(segment.size()) >= min_px) continue;
    for (const cv::Point p : segment) kept(p) = 0;
  }
  return kept;
}

/// Disparities that are noise make winding segments of every size.
TEST(SmallSegments, AreThoseOfAFloodFill) {
  cv::RNG random(21);
  for (const cv::Size size :
       {cv::Size(1, 1), cv::Size(1, 70), cv::Size(70, 1), cv::Size(97, 131)}) {
    for (const double share_valid : {0.5, 0.7, 0.9}) {
      for (const double spread_px : {0.3, 0.5, 0.8}) {
        DisparityField field = Flat(size.height, size.width);
        random.fill(field.dx, cv::RNG::NORMAL, 0, spread_px);
        random.fill(field.dy, cv::RNG::NORMAL, 0, spread_px);
        for (uchar& valid : field.valid) valid = random.uniform(0.0, 1.0) < share_valid ? 255 : 0;
        for (const int min_px : {1, 2, 10, 60, 1000}) {
          DisparityField checked = field;
          checked.valid = field.valid.clone();
          InvalidateSmallSegments(min_px, 0.9, checked);
          const cv::Mat1b expected = KeptByFloodFill(min_px, 0.9F, field);
          EXPECT_EQ(cv::countNonZero(checked.valid != expected), 0)
              << size << " " << share_valid << " " << spread_px << " " << min_px;
        }
      }
    }
  }
}

TEST(SmallSegments, AreTheSameOnAnyNumberOfThreads) {
  cv::RNG random(22);
  DisparityField field = Flat(243, 321);
  random.fill(field.dx, cv::RNG::NORMAL, 0, 0.5);
  DisparityField one = field, five = field;
  one.valid = field.valid.clone();
  five.valid = field.valid.clone();
  testing::OnThreads(1, [&] { InvalidateSmallSegments(30, 0.9, one); });
  testing::OnThreads(5, [&] { InvalidateSmallSegments(30, 0.9, five); });
  EXPECT_EQ(cv::countNonZero(one.valid != five.valid), 0);
}

}  // namespace
}  // namespace horopter::vision
