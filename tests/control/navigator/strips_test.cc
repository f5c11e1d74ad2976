// SPDX-License-Identifier: Apache-2.0
#include "control/navigator/strips.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace horopter::control {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// An empty view of 100x20 pixels with regions 1 and 2.
SceneView EmptyView() {
  SceneView view;
  view.regions.labels = cv::Mat1i(20, 100, 0);
  view.regions.regions.resize(2);
  view.obstacles_B = cv::Mat3f(20, 100, cv::Vec3f::all(kNan));
  view.floor_B = view.obstacles_B.clone();
  return view;
}

void Put(SceneView& view, cv::Rect where, int label, cv::Vec3f p) {
  view.regions.labels(where) = label;
  view.obstacles_B(where).setTo(p);
}

TEST(Strips, ImageAreasAreColumns) {
  SceneView view = EmptyView();
  Put(view, {0, 0, 20, 20}, 1, {0.8f, 0, 0.2f});
  Put(view, {80, 0, 20, 20}, 2, {0.6f, 0, 0.2f});
  const auto m = MeasureStrips(view, ObstacleTest::kCentralImage, 0, {});
  EXPECT_NEAR(m.near_m(Strip::kLeft), 0.8, 1e-6);
  EXPECT_NEAR(m.near_m(Strip::kRight), 0.6, 1e-6);
  EXPECT_TRUE(std::isinf(m.near_m(Strip::kCentre)));
  EXPECT_EQ(m.right->label, 2);
  EXPECT_EQ(m.right->count, 400);
}

TEST(Strips, AMergedRegionCountsInEachAreaWithItsPixelsThere) {
  // One region across the image: near on the left, far in the middle. Its box overlaps the centre.
  SceneView view = EmptyView();
  Put(view, {0, 0, 100, 20}, 1, {2.0f, 0, 0.2f});
  Put(view, {0, 0, 20, 20}, 1, {0.4f, 0, 0.2f});
  const auto m = MeasureStrips(view, ObstacleTest::kCentralImage, 0, {});
  EXPECT_NEAR(m.near_m(Strip::kLeft), 0.4, 1e-6);
  EXPECT_NEAR(m.near_m(Strip::kCentre), 2.0, 1e-6);
}

TEST(Strips, CorridorAreasAreOnTheGround) {
  SceneView view = EmptyView();
  Put(view, {0, 0, 10, 20}, 1, {1.0f, 0.5f, 0.2f});  // left of the corridor
  Put(view, {10, 0, 10, 20}, 2, {0.7f, -0.2f, 0.2f});
  const auto ahead = MeasureStrips(view, ObstacleTest::kCorridor, 0, {});
  EXPECT_NEAR(ahead.near_m(Strip::kLeft), std::hypot(1, 0.5), 1e-6);
  EXPECT_NEAR(ahead.near_m(Strip::kCentre), 0.7, 1e-6);
  EXPECT_EQ(ahead.centre->label, 2);

  // The corridor towards the first thing has it in the middle and the other on the right.
  const auto left = MeasureStrips(view, ObstacleTest::kCorridor, std::atan2(0.5, 1.0), {});
  EXPECT_NEAR(left.near_m(Strip::kCentre), std::hypot(1, 0.5), 1e-6);
  EXPECT_EQ(left.centre->label, 1);
  EXPECT_NEAR(left.near_m(Strip::kRight), std::hypot(0.7, 0.2), 1e-6);

  // Looking the other way, nothing is ahead.
  const auto back = MeasureStrips(view, ObstacleTest::kCorridor, M_PI, {});
  EXPECT_FALSE(back.left || back.centre || back.right);
}

TEST(Strips, FewPixelsDoNotCount) {
  SceneView view = EmptyView();
  Put(view, {45, 0, 6, 4}, 1, {0.5f, 0, 0.2f});  // 24 of the 25 it needs
  EXPECT_TRUE(
      std::isinf(MeasureStrips(view, ObstacleTest::kCentralImage, 0, {}).near_m(Strip::kCentre)));
  Put(view, {45, 4, 1, 1}, 1, {0.5f, 0, 0.2f});
  EXPECT_NEAR(MeasureStrips(view, ObstacleTest::kCentralImage, 0, {}).near_m(Strip::kCentre), 0.5,
              1e-6);
}

TEST(Strips, AFewMismatchesOnTheFloorAreNoObstacle) {
  SceneView view = EmptyView();
  view.regions.labels = 1;
  view.floor_B(cv::Rect(30, 0, 40, 20)).setTo(cv::Vec3f(1, 0, 0));
  const cv::Rect wrong(40, 5, 6, 6);  // 36 of 800 pixels: 4.5 %
  view.floor_B(wrong).setTo(cv::Vec3f::all(kNan));
  view.obstacles_B(wrong).setTo(cv::Vec3f(0.4f, 0, 0.2f));
  EXPECT_FALSE(MeasureStrips(view, ObstacleTest::kCentralImage, 0, {}).centre.has_value());
  view.floor_B(cv::Rect(30, 0, 40, 4)).setTo(cv::Vec3f::all(kNan));  // now 36 of 640
  EXPECT_TRUE(MeasureStrips(view, ObstacleTest::kCentralImage, 0, {}).centre.has_value());
}

TEST(Strips, EdgePixelsCountUnlessToldOtherwise) {
  SceneView view = EmptyView();
  Put(view, {40, 0, 10, 10}, 0, {0.5f, 0, 0.2f});
  StripConfig config;
  EXPECT_EQ(MeasureStrips(view, ObstacleTest::kCentralImage, 0, config).centre->label, 0);
  config.edges_count = false;
  EXPECT_FALSE(MeasureStrips(view, ObstacleTest::kCentralImage, 0, config).centre.has_value());
}

TEST(Strips, PointsAndNearest) {
  const auto points = MeasurePoints({{1.0, 0.1}, {0.8, 0}, {0.5, 0.9}, {-1, 0}}, 0, {});
  EXPECT_NEAR(points.near_m(Strip::kCentre), 0.8, 1e-12);
  EXPECT_EQ(points.centre->count, 2);
  EXPECT_EQ(points.centre->label, Obstacle::kRemembered);
  EXPECT_NEAR(points.near_m(Strip::kLeft), std::hypot(0.5, 0.9), 1e-12);
  EXPECT_FALSE(points.right.has_value());
  const auto both = Nearest(points, MeasurePoints({{0.6, 0}, {2, 2}, {1, -1}}, 0, {}));
  EXPECT_NEAR(both.near_m(Strip::kCentre), 0.6, 1e-12);
  EXPECT_NEAR(both.near_m(Strip::kLeft), std::hypot(0.5, 0.9), 1e-12);
  EXPECT_TRUE(both.right.has_value());
}

TEST(Strips, ValidateNamesEveryBadField) {
  EXPECT_TRUE(StripConfig{}.Validate().empty());
  EXPECT_EQ((StripConfig{1, 0, 0, 1, true}.Validate().size()), 4u);
}

}  // namespace
}  // namespace horopter::control
