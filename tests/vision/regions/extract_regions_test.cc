// SPDX-License-Identifier: Apache-2.0
#include "vision/regions/extract_regions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <random>

namespace horopter::vision {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

RegionConfig Everything() {
  RegionConfig config;
  config.min_area_px = 1;
  return config;
}

struct Input {
  cv::Mat1b interior;
  cv::Mat bgr;
  cv::Mat1f depth;
};

Input RandomInput(int seed, double density, cv::Size size) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  Input in{cv::Mat1b(size), cv::Mat(size, CV_8UC3), cv::Mat1f(size)};
  for (int v = 0; v < size.height; ++v) {
    for (int u = 0; u < size.width; ++u) {
      in.interior(v, u) = uniform(generator) < density ? 255 : 0;
      in.depth(v, u) = uniform(generator) < 0.3 ? kNan : static_cast<float>(uniform(generator));
      for (int c = 0; c < 3; ++c) {
        in.bgr.at<cv::Vec3b>(v, u)[c] = static_cast<uchar>(256 * uniform(generator));
      }
    }
  }
  return in;
}

/// Flood fill from every pixel not yet labelled, in scan order: the definition.
std::vector<std::vector<cv::Point>> BruteForce(const cv::Mat1b& interior) {
  cv::Mat1b todo = interior.clone();
  std::vector<std::vector<cv::Point>> regions;
  for (int v = 0; v < todo.rows; ++v) {
    for (int u = 0; u < todo.cols; ++u) {
      if (todo(v, u) == 0) continue;
      std::vector<cv::Point> region{{u, v}};
      todo(v, u) = 0;
      for (std::size_t i = 0; i < region.size(); ++i) {
        const cv::Point p = region[i];
        for (int y = std::max(p.y - 1, 0); y <= std::min(p.y + 1, todo.rows - 1); ++y) {
          for (int x = std::max(p.x - 1, 0); x <= std::min(p.x + 1, todo.cols - 1); ++x) {
            if (todo(y, x) == 0) continue;
            todo(y, x) = 0;
            region.push_back({x, y});
          }
        }
      }
      regions.push_back(region);
    }
  }
  return regions;
}

void ExpectRegion(const Region& region, const std::vector<cv::Point>& pixels, const Input& in) {
  cv::Vec3d colour, centroid;
  std::vector<float> depths;
  for (const cv::Point& p : pixels) {
    centroid += cv::Vec3d(p.x, p.y, 0);
    colour += cv::Vec3d(in.bgr.at<cv::Vec3b>(p));
    if (!std::isnan(in.depth(p))) depths.push_back(in.depth(p));
  }
  const auto n = static_cast<double>(pixels.size());
  EXPECT_EQ(region.area_px, static_cast<int>(pixels.size()));
  EXPECT_EQ(region.box, cv::boundingRect(pixels));
  EXPECT_NEAR(region.centroid.x, centroid[0] / n, 1e-9);
  EXPECT_NEAR(region.centroid.y, centroid[1] / n, 1e-9);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(region.mean_bgr[c], colour[c] / n, 1e-9);
  ASSERT_EQ(region.depth.count, static_cast<int>(depths.size()));
  if (depths.empty()) {
    EXPECT_TRUE(std::isnan(region.depth.mean_m) && std::isnan(region.depth.near_m));
    return;
  }
  std::sort(depths.begin(), depths.end());
  EXPECT_EQ(region.depth.min_m, depths.front());
  EXPECT_EQ(region.depth.near_m, depths[static_cast<std::size_t>(0.05 * depths.size())]);
}

TEST(ExtractRegions, MatchesFloodFillOnRandomMaps) {
  for (const double density : {0.05, 0.35, 0.45, 0.8}) {
    const Input in = RandomInput(static_cast<int>(100 * density), density, {53, 37});
    const auto expected = BruteForce(in.interior);
    const RegionMap map = ExtractRegions(in.interior, in.bgr, in.depth, Everything());
    ASSERT_EQ(map.regions.size(), expected.size());
    cv::Mat1i labels(in.interior.size(), 0);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_EQ(map.regions[i].label, static_cast<int>(i) + 1);
      for (const cv::Point& p : expected[i]) labels(p) = static_cast<int>(i) + 1;
      ExpectRegion(map.regions[i], expected[i], in);
    }
    EXPECT_EQ(cv::norm(map.labels, labels, cv::NORM_INF), 0);
  }
}

TEST(ExtractRegions, SmallRegionsCountAsEdgesAndLabelsStayDense) {
  cv::Mat1b interior(20, 40, uchar{0});
  interior(cv::Rect(1, 1, 3, 3)) = 255;    // 9 px
  interior(cv::Rect(10, 2, 10, 8)) = 255;  // 80 px
  interior(cv::Rect(30, 4, 5, 10)) = 255;  // 50 px
  const RegionMap map = ExtractRegions(interior, {}, {});
  ASSERT_EQ(map.regions.size(), 2u);
  EXPECT_EQ(map.regions[0].box, cv::Rect(10, 2, 10, 8));
  EXPECT_EQ(map.regions[1].box, cv::Rect(30, 4, 5, 10));
  EXPECT_EQ(map.labels(2, 2), 0);
  EXPECT_EQ(map.labels(5, 32), 2);
  EXPECT_EQ(map.regions[0].depth.count, 0);
}

TEST(ExtractRegions, DiagonalNeighboursAreConnected) {
  const cv::Mat1b interior = 255 * cv::Mat1b::eye(8, 8);
  EXPECT_EQ(ExtractRegions(interior, {}, {}, Everything()).regions.size(), 1u);
}

TEST(ExtractRegions, SameLabelsForAnyNumberOfThreads) {
  const Input in = RandomInput(9, 0.4, {320, 240});
  const int before = cv::getNumThreads();
  cv::setNumThreads(1);
  const RegionMap one = ExtractRegions(in.interior, in.bgr, in.depth);
  cv::setNumThreads(4);
  const RegionMap four = ExtractRegions(in.interior, in.bgr, in.depth);
  cv::setNumThreads(before);
  EXPECT_EQ(cv::norm(one.labels, four.labels, cv::NORM_INF), 0);
  ASSERT_EQ(one.regions.size(), four.regions.size());
}

TEST(ExtractRegions, EmptyMapsAndBadInput) {
  EXPECT_TRUE(ExtractRegions(cv::Mat1b(), {}, {}).regions.empty());
  EXPECT_TRUE(ExtractRegions(cv::Mat1b(4, 4, uchar{0}), {}, {}, Everything()).regions.empty());
  const cv::Mat1b interior(4, 4, uchar{255});
  EXPECT_THROW((void)ExtractRegions(interior, cv::Mat(4, 5, CV_8UC3), {}), std::invalid_argument);
  EXPECT_THROW((void)ExtractRegions(interior, cv::Mat(4, 4, CV_8UC1), {}), std::invalid_argument);
  EXPECT_THROW((void)ExtractRegions(interior, {}, cv::Mat1f(5, 4)), std::invalid_argument);
  RegionConfig config;
  config.min_area_px = 0;
  config.near_fraction = 1;
  EXPECT_EQ(config.Validate().size(), 2u);
  EXPECT_THROW((void)ExtractRegions(interior, {}, {}, config), hardware::ConfigError);
}

}  // namespace
}  // namespace horopter::vision
