// SPDX-License-Identifier: Apache-2.0
#include "control/navigator/obstacle_points.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "control/navigator/scene_view.h"

namespace horopter::control {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// A 9x9 field full of one point.
vision::PointField Full(cv::Vec3f p) { return {cv::Mat3f(9, 9, p), cv::Mat1f(9, 9, 0.f)}; }

bool Stands(const vision::PointField& field) {
  return !std::isnan(Split(field, {}).obstacles(4, 4)[0]);
}

bool IsFloor(const vision::PointField& field) {
  return !std::isnan(Split(field, {}).floor(4, 4)[0]);
}

TEST(ObstaclePoints, HeightTellsFloorFromObstacleFromOverhead) {
  EXPECT_TRUE(IsFloor(Full({1, 0, 0.029f})));
  EXPECT_FALSE(Stands(Full({1, 0, 0.029f})));
  EXPECT_TRUE(Stands(Full({1, 0, 0.031f})));
  EXPECT_FALSE(IsFloor(Full({1, 0, 0.031f})));
  EXPECT_TRUE(Stands(Full({1, 0, 0.44f})));
  for (const float z : {0.46f, -0.2f}) {
    EXPECT_FALSE(Stands(Full({1, 0, z})));
    EXPECT_FALSE(IsFloor(Full({1, 0, z})));
  }
}

TEST(ObstaclePoints, RangeResidualAndSideCount) {
  EXPECT_FALSE(Stands(Full({-1, 0, 0.2f})));
  EXPECT_FALSE(Stands(Full({0.05f, 0, 0.2f})));
  EXPECT_FALSE(Stands(Full({2.9f, 1.5f, 0.2f})));
  EXPECT_TRUE(Stands(Full({0.05f, 0.2f, 0.2f})));
  vision::PointField loose = Full({1, 0, 0.2f});
  loose.residual_m = 0.03f;
  EXPECT_FALSE(Stands(loose));
}

TEST(ObstaclePoints, APointNeedsNeighboursAboutAsFar) {
  vision::PointField field = Full({2, 0, 0.2f});
  field.points(4, 4) = {1, 0, 0.2f};
  EXPECT_FALSE(Stands(field));
  for (int u = 2; u < 6; ++u) field.points(3, u) = {1.05f, 0, 0.2f};
  EXPECT_FALSE(Stands(field));  // four of the five it needs
  field.points(5, 5) = {1.05f, 0, 0.2f};
  EXPECT_TRUE(Stands(field));
}

TEST(ObstaclePoints, ValidateNamesEveryBadField) {
  EXPECT_TRUE(ObstacleConfig{}.Validate().empty());
  ObstacleConfig bad;
  bad.pit_m = 1;
  bad.robot_height_m = 0;
  bad.min_range_m = -1;
  bad.max_range_m = -2;
  bad.max_residual_m = 0;
  bad.support_px = 30;
  bad.support_tolerance = 0;
  EXPECT_EQ(bad.Validate().size(), 7u);
  EXPECT_THROW((void)Split(Full({1, 0, 0}), bad), hardware::ConfigError);
}

TEST(SceneView, RefusesLabelsOfAnotherSize) {
  vision::RegionMap regions;
  regions.labels = cv::Mat1i(9, 8, 0);
  EXPECT_THROW((void)MakeSceneView({}, regions, Split(Full({1, 0, 0}), {})), std::invalid_argument);
  regions.labels = cv::Mat1i(9, 9, 0);
  EXPECT_EQ(MakeSceneView({}, regions, Split(Full({1, 0, 0}), {})).size(), cv::Size(9, 9));
}

}  // namespace
}  // namespace horopter::control
