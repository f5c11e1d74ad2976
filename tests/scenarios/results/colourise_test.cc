// SPDX-License-Identifier: Apache-2.0
#include "scenarios/results/colourise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "scenarios/results/frame_pictures.h"

namespace horopter::scenarios {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

double Lightness(const cv::Vec3b& bgr) {
  cv::Mat3f pixel(1, 1, cv::Vec3f(bgr) / 255.f);
  cv::Mat3f lab;
  cv::cvtColor(pixel, lab, cv::COLOR_BGR2Lab);
  return lab(0, 0)[0];
}

double Distance(const cv::Vec3b& a, const cv::Vec3b& b) {
  return cv::norm(cv::Vec3d(a) - cv::Vec3d(b));
}

TEST(ColourMap, DepthDarkensSteadilyWithDistance) {
  for (int i = 1; i <= 64; ++i) {
    EXPECT_LT(Lightness(MapColour(ColourMap::kDepth, i / 64.0)),
              Lightness(MapColour(ColourMap::kDepth, (i - 1) / 64.0)) + 0.6);
  }
  EXPECT_GT(Lightness(MapColour(ColourMap::kDepth, 0)), 80);
  EXPECT_LT(Lightness(MapColour(ColourMap::kDepth, 1)), 20);
}

TEST(ColourMap, DivergingMapsAreLightestAtZeroAndBalanced) {
  for (const ColourMap map : {ColourMap::kDisparity, ColourMap::kSignedError}) {
    EXPECT_GT(Lightness(MapColour(map, 0.5)), 93);
    for (const double side : {-1.0, 1.0}) {
      for (int i = 1; i <= 32; ++i) {
        EXPECT_LE(Lightness(MapColour(map, 0.5 + side * i / 64)),
                  Lightness(MapColour(map, 0.5 + side * (i - 1) / 64)) + 0.6);
      }
    }
    EXPECT_GT(Distance(MapColour(map, 0), MapColour(map, 1)), 150);
  }
}

TEST(ColouriseDepth, IsLogarithmicAndClamped) {
  const cv::Mat1f depth = (cv::Mat1f(1, 5) << 0.1f, 0.5f, 1.f, 2.f, 9.f);
  const cv::Mat3b picture = ColouriseDepth(depth, 0.5, 2);
  EXPECT_EQ(picture(0, 0), MapColour(ColourMap::kDepth, 0));
  EXPECT_EQ(picture(0, 1), MapColour(ColourMap::kDepth, 0));
  EXPECT_EQ(picture(0, 2), MapColour(ColourMap::kDepth, 0.5));
  EXPECT_EQ(picture(0, 3), MapColour(ColourMap::kDepth, 1));
  EXPECT_EQ(picture(0, 4), MapColour(ColourMap::kDepth, 1));
}

TEST(Colourise, ShowsInvalidPixelsInAColourOfTheirOwn) {
  cv::Mat1f depth(12, 12, kNaN);
  depth(0, 1) = -1;
  depth(0, 2) = 0;
  depth(0, 3) = std::numeric_limits<float>::infinity();
  const cv::Mat3b picture = ColouriseDepth(depth, 0.3, 5);
  const cv::Mat3b error = ColouriseSignedError(depth(cv::Rect(0, 1, 12, 11)), 1);
  for (const ColourMap map : {ColourMap::kDepth, ColourMap::kDisparity, ColourMap::kSignedError}) {
    for (int i = 0; i < 256; ++i) {
      const cv::Vec3b colour = MapColour(map, i / 255.0);
      for (const cv::Vec3b& invalid : picture) ASSERT_GT(Distance(colour, invalid), 20);
      for (const cv::Vec3b& invalid : error) ASSERT_GT(Distance(colour, invalid), 20);
    }
  }
  EXPECT_NE(picture(0, 0), picture(0, 4)) << "hatched, not plain";
}

TEST(ColouriseDisparity, BelievesTheMaskOverTheNumber) {
  vision::DisparityField field{cv::Mat1f(1, 3, 0.f), cv::Mat1f(1, 3, 0.f), cv::Mat1f(1, 3, 1.f),
                               cv::Mat1b(1, 3, uchar{255})};
  field.dx(0, 1) = -30;
  field.valid(0, 2) = 0;
  const cv::Mat3b picture = ColouriseDisparity(field, 30);
  EXPECT_EQ(picture(0, 0), MapColour(ColourMap::kDisparity, 0.5));
  EXPECT_EQ(picture(0, 1), MapColour(ColourMap::kDisparity, 0));
  EXPECT_NE(picture(0, 2), picture(0, 0));
}

TEST(Colourise, RefusesAScaleThatIsNone) {
  const cv::Mat1f map(2, 2, 1.f);
  EXPECT_THROW(ColouriseDepth(map, 0, 1), std::invalid_argument);
  EXPECT_THROW(ColouriseDepth(map, 2, 1), std::invalid_argument);
  EXPECT_THROW(ColouriseSignedError(map, 0), std::invalid_argument);
  EXPECT_THROW(ColouriseSignedError(map, std::nan("")), std::invalid_argument);
}

TEST(DrawRegions, TintsByDepthAndLeavesTheRestGrey) {
  const cv::Mat3b image(40, 60, cv::Vec3b(20, 120, 220));
  vision::RegionMap regions;
  regions.labels = cv::Mat1i(40, 60, 0);
  regions.labels(cv::Rect(0, 0, 20, 40)) = 1;
  regions.labels(cv::Rect(22, 0, 18, 40)) = 2;
  vision::Region with_depth;
  with_depth.label = 1;
  with_depth.depth = {800, 0.5, 0.4, 0.1, 0.45};
  vision::Region without;
  without.label = 2;
  regions.regions = {with_depth, without};
  const cv::Mat3b picture = DrawRegions(image, regions, 0.3, 5);
  const cv::Vec3b tinted = picture(20, 10);
  const cv::Vec3b grey = picture(20, 30);
  EXPECT_NE(tinted[0], tinted[2]);
  EXPECT_EQ(grey[0], grey[1]);
  EXPECT_EQ(grey[1], grey[2]);
  EXPECT_LT(picture(20, 21)[0], grey[0]) << "edges are dark";
  EXPECT_THROW(DrawRegions(cv::Mat3b(10, 10), regions, 0.3, 5), std::invalid_argument);
}

TEST(LegendStrip, RunsFromOneEndOfTheMapToTheOther) {
  const cv::Mat3b strip = LegendStrip(ColourMap::kSignedError, -25, 25, "%", 300);
  EXPECT_EQ(strip.cols, 300);
  EXPECT_EQ(strip(3, 0), MapColour(ColourMap::kSignedError, 0));
  EXPECT_LT(Distance(strip(3, (300 - 54) - 1), MapColour(ColourMap::kSignedError, 1)), 3);
}

TEST(MakeFrameImages, LeavesOutWhatNeedsTruthWhereThereIsNone) {
  const cv::Size size(8, 6);
  hardware::StereoFrame frame;
  frame.left.bgr = cv::Mat3b(size, cv::Vec3b(1, 2, 3));
  frame.right.bgr = frame.left.bgr;
  const vision::DisparityField field{cv::Mat1f(size, 0.f), cv::Mat1f(size, 0.f),
                                     cv::Mat1f(size, 1.f), cv::Mat1b(size, uchar{255})};
  vision::RegionMap regions;
  regions.labels = cv::Mat1i(size, 0);
  const cv::Mat1f depth(size, 2.f);
  const FrameImages without = MakeFrameImages(frame, field, depth, {}, regions);
  EXPECT_TRUE(without.true_depth_bgr.empty());
  EXPECT_TRUE(without.depth_error_bgr.empty());
  const FrameImages with = MakeFrameImages(frame, field, depth, cv::Mat1f(size, 2.f), regions);
  EXPECT_EQ(cv::norm(with.depth_bgr, with.true_depth_bgr), 0) << "equal depth, equal colour";
  EXPECT_EQ(with.depth_error_bgr.at<cv::Vec3b>(0, 0), MapColour(ColourMap::kSignedError, 0.5));
  EXPECT_THROW(MakeFrameImages(frame, field, cv::Mat1f(3, 3), {}, regions), std::invalid_argument);
}

}  // namespace
}  // namespace horopter::scenarios
