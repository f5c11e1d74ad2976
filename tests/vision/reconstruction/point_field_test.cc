// SPDX-License-Identifier: Apache-2.0
#include "vision/reconstruction/point_field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace horopter::vision {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

PointField TwoPoints() {
  PointField field{cv::Mat3f(1, 3, cv::Vec3f::all(kNan)), cv::Mat1f(1, 3, kNan)};
  field.points(0, 0) = {1, 2, 3};
  field.points(0, 2) = {-4, 5, -6};
  field.residual_m(0, 0) = 0.25f;
  return field;
}

TEST(PointField, TransformedMovesEveryPointAndKeepsTheRest) {
  hardware::Pose X_AB = hardware::ToPose({10, 20, M_PI / 2}, 30);
  const PointField moved = Transformed(TwoPoints(), X_AB);
  EXPECT_LT(cv::norm(moved.points(0, 0) - cv::Vec3f(8, 21, 33)), 1e-5);
  EXPECT_LT(cv::norm(moved.points(0, 2) - cv::Vec3f(5, 16, 24)), 1e-5);
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(std::isnan(moved.points(0, 1)[i]));
  EXPECT_EQ(moved.residual_m(0, 0), 0.25f);
  EXPECT_TRUE(std::isnan(moved.residual_m(0, 1)));
}

TEST(PointField, TransformedDoesNotShareItsPixels) {
  const PointField original = TwoPoints();
  PointField moved = Transformed(original, hardware::Pose::Identity());
  moved.residual_m(0, 0) = 9;
  moved.points(0, 0)[0] = 9;
  EXPECT_EQ(original.residual_m(0, 0), 0.25f);
  EXPECT_EQ(original.points(0, 0)[0], 1);
}

TEST(PointField, DepthIsMeasuredAlongTheOpticalAxis) {
  hardware::Pose X_BC = hardware::Pose::Identity();
  X_BC.linear() = hardware::OpticalToBody();
  X_BC.translation() << 0.25, 0, 0;
  const cv::Mat1f depth = DepthAlongOptical(TwoPoints(), X_BC);
  EXPECT_FLOAT_EQ(depth(0, 0), 0.75f);
  EXPECT_TRUE(std::isnan(depth(0, 1)));
  EXPECT_FLOAT_EQ(depth(0, 2), -4.25f);

  // A camera that looks to the left measures y.
  X_BC.linear() = Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ()) * X_BC.linear();
  EXPECT_FLOAT_EQ(DepthAlongOptical(TwoPoints(), X_BC)(0, 2), 5.0f);
}

}  // namespace
}  // namespace horopter::vision
