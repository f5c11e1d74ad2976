// SPDX-License-Identifier: Apache-2.0
#include "hardware/types/pose.h"

#include <gtest/gtest.h>

#include <cmath>

namespace horopter::hardware {
namespace {

using Eigen::Vector3d;

TEST(WrapAngle, StaysInTheHalfOpenIntervalAndKeepsTheDirection) {
  for (int i = -200; i <= 200; ++i) {
    const double angle = i * 0.37;
    const double wrapped = WrapAngle(angle);
    EXPECT_GT(wrapped, -M_PI);
    EXPECT_LE(wrapped, M_PI);
    EXPECT_NEAR(std::cos(wrapped), std::cos(angle), 1e-12);
    EXPECT_NEAR(std::sin(wrapped), std::sin(angle), 1e-12);
  }
  EXPECT_DOUBLE_EQ(WrapAngle(-M_PI), M_PI);
  EXPECT_DOUBLE_EQ(WrapAngle(3 * M_PI), M_PI);
  EXPECT_TRUE(std::isnan(WrapAngle(NAN)));
}

TEST(ToPose, TurnsForwardToTheLeftForPositiveHeadings) {
  const Pose X_WB = ToPose({1, 2, M_PI / 2}, 0.5);
  EXPECT_LT((X_WB * Vector3d(1, 0, 0) - Vector3d(1, 3, 0.5)).norm(), 1e-12);
  EXPECT_LT((X_WB * Vector3d(0, 1, 0) - Vector3d(0, 2, 0.5)).norm(), 1e-12);
}

TEST(OpticalToBody, IsARotationThatTakesForwardRightAndDownToTheirBodyAxes) {
  const Eigen::Matrix3d R = OpticalToBody();
  EXPECT_NEAR(R.determinant(), 1, 1e-15);
  EXPECT_LT((R.transpose() * R - Eigen::Matrix3d::Identity()).norm(), 1e-15);
  EXPECT_EQ(R * Vector3d::UnitZ(), Vector3d::UnitX());   // forward
  EXPECT_EQ(R * Vector3d::UnitX(), -Vector3d::UnitY());  // right is minus left
  EXPECT_EQ(R * Vector3d::UnitY(), -Vector3d::UnitZ());  // down is minus up
}

TEST(Pose, PlanarPoseSurvivesLiftingAndTilting) {
  const Pose2 pose{1, -2, 2.5};
  Pose X = ToPose(pose, 0.3);
  X.linear() = X.linear() * Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitY());  // nose down
  const Pose2 back = ToPose2(X);
  EXPECT_NEAR(back.x_m, pose.x_m, 1e-12);
  EXPECT_NEAR(back.y_m, pose.y_m, 1e-12);
  EXPECT_NEAR(back.heading_rad, pose.heading_rad, 1e-12);
}

}  // namespace
}  // namespace horopter::hardware
