// SPDX-License-Identifier: Apache-2.0
#include "vision/segmentation/colour_edges.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <random>

namespace horopter::vision {
namespace {

cv::Mat Plain(cv::Scalar bgr, cv::Size size = {60, 40}) { return cv::Mat(size, CV_8UC3, bgr); }

/// Left half one colour, right half another, boundary between columns 29 and 30.
cv::Mat TwoHalves(cv::Scalar left, cv::Scalar right) {
  cv::Mat image = Plain(left);
  image(cv::Rect(30, 0, 30, 40)) = right;
  return image;
}

cv::Mat RandomImage(int seed, cv::Size size) {
  cv::Mat image(size, CV_8UC3);
  std::mt19937 generator(seed);
  for (auto it = image.begin<cv::Vec3b>(); it != image.end<cv::Vec3b>(); ++it) {
    for (int c = 0; c < 3; ++c) (*it)[c] = static_cast<uchar>(generator() % 40);
  }
  return image;
}

TEST(ColourEdges, PlainImageIsAllInterior) {
  EXPECT_EQ(cv::countNonZero(FindColourEdges(Plain({10, 200, 90}))), 60 * 40);
}

TEST(ColourEdges, BoundaryIsTwoPixelsWideAndNothingElse) {
  for (const GradientKernel kernel : {GradientKernel::kCentral, GradientKernel::kSobel}) {
    ColourEdgesConfig config;
    config.kernel = kernel;
    const cv::Mat1b edges = FindColourEdges(TwoHalves({0, 0, 200}, {200, 0, 0}), config);
    cv::Mat1b expected(40, 60, uchar{255});
    expected.colRange(29, 31) = 0;
    EXPECT_EQ(cv::norm(edges, expected, cv::NORM_INF), 0);
  }
}

TEST(ColourEdges, ColoursOfEqualBrightnessAreSeparated) {
  const cv::Mat image = TwoHalves({60, 100, 40}, {80, 80, 71});
  cv::Mat1b grey;
  cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
  ASSERT_LE(std::abs(grey(20, 10) - grey(20, 50)), 1);
  EXPECT_EQ(FindColourEdges(image)(20, 30), 0);
}

TEST(ColourEdges, ThresholdIsTheSumOverChannels) {
  // 7 + 7 + 7 = 21 is not above the threshold; one more is.
  EXPECT_EQ(FindColourEdges(TwoHalves({50, 50, 50}, {57, 57, 57}))(20, 30), 255);
  EXPECT_EQ(FindColourEdges(TwoHalves({50, 50, 50}, {57, 57, 58}))(20, 30), 0);
  ColourEdgesConfig sobel;
  sobel.kernel = GradientKernel::kSobel;
  EXPECT_EQ(FindColourEdges(TwoHalves({50, 50, 50}, {57, 57, 57}), sobel)(20, 30), 255);
  EXPECT_EQ(FindColourEdges(TwoHalves({50, 50, 50}, {57, 57, 58}), sobel)(20, 30), 0);
}

TEST(ColourEdges, MedianRemovesSpecklesAndKeepsTheBoundary) {
  cv::Mat image = TwoHalves({0, 0, 200}, {200, 0, 0});
  const cv::Mat1b clean = FindColourEdges(image);
  std::mt19937 generator(1);
  for (int i = 0; i < 40; ++i) {
    image.at<cv::Vec3b>(generator() % 40, generator() % 60) = {255, 255, 255};
  }
  EXPECT_GE(cv::countNonZero(FindColourEdges(image) == clean), 60 * 40 - 12);
  ColourEdgesConfig unfiltered;
  unfiltered.median_px = 1;
  EXPECT_LT(cv::countNonZero(FindColourEdges(image, unfiltered) == clean), 60 * 40 - 100);
}

TEST(ColourEdges, LeavesTheImageAsItWas) {
  const cv::Mat image = RandomImage(2, {30, 20});
  const cv::Mat before = image.clone();
  (void)FindColourEdges(image);
  EXPECT_EQ(cv::norm(image, before, cv::NORM_INF), 0);
}

TEST(ColourEdges, MatchesTheDefinitionPixelByPixel) {
  const cv::Mat image = RandomImage(5, {31, 23});
  cv::Mat gx, gy;
  for (const GradientKernel kernel : {GradientKernel::kCentral, GradientKernel::kSobel}) {
    ColourEdgesConfig config;
    config.median_px = 1;
    config.threshold = 60;
    config.kernel = kernel;
    const bool sobel = kernel == GradientKernel::kSobel;
    if (sobel) {
      cv::Sobel(image, gx, CV_32F, 1, 0, 3, 0.25, 0, cv::BORDER_REPLICATE);
      cv::Sobel(image, gy, CV_32F, 0, 1, 3, 0.25, 0, cv::BORDER_REPLICATE);
    } else {
      const cv::Mat1f row = (cv::Mat1f(1, 3) << -1, 0, 1);
      cv::filter2D(image, gx, CV_32F, row, {-1, -1}, 0, cv::BORDER_REPLICATE);
      cv::filter2D(image, gy, CV_32F, row.t(), {-1, -1}, 0, cv::BORDER_REPLICATE);
    }
    const cv::Mat1b edges = FindColourEdges(image, config);
    int edge_count = 0;
    for (int v = 0; v < image.rows; ++v) {
      for (int u = 0; u < image.cols; ++u) {
        const double sum = cv::norm(gx.at<cv::Vec3f>(v, u), cv::NORM_L1) +
                           cv::norm(gy.at<cv::Vec3f>(v, u), cv::NORM_L1);
        EXPECT_EQ(edges(v, u), sum > 60 ? 0 : 255) << u << "," << v;
        edge_count += sum > 60;
      }
    }
    EXPECT_GT(edge_count, 50);
    EXPECT_LT(edge_count, 31 * 23 - 50);
  }
}

TEST(ColourEdges, TinyImagesAndBadInput) {
  EXPECT_EQ(FindColourEdges(Plain({1, 2, 3}, {1, 1}))(0, 0), 255);
  EXPECT_THROW((void)FindColourEdges(cv::Mat()), std::invalid_argument);
  EXPECT_THROW((void)FindColourEdges(cv::Mat1b(4, 4, uchar{0})), std::invalid_argument);
  ColourEdgesConfig config;
  config.median_px = 4;
  config.threshold = -1;
  EXPECT_EQ(config.Validate().size(), 2u);
  EXPECT_THROW((void)FindColourEdges(Plain({1, 2, 3}), config), hardware::ConfigError);
}

}  // namespace
}  // namespace horopter::vision
