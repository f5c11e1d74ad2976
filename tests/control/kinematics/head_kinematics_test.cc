// SPDX-License-Identifier: Apache-2.0
#include "control/kinematics/head_kinematics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "tests/control/kinematics/heads.h"

namespace horopter::control {
namespace {

using hardware::Eye;
using hardware::HeadAngles;
using hardware::HeadGeometry;
using hardware::Pose;

void ExpectNear(const Eigen::Vector3d& actual, double x, double y, double z) {
  EXPECT_TRUE(((actual - Eigen::Vector3d(x, y, z)).norm() <= 1e-12))
      << "actual " << actual.transpose() << ", expected " << x << " " << y << " " << z;
}

TEST(HeadKinematics, HeadAtRestLooksForward) {
  const Pose X_BCl = EyePose(KoalaHead(), {}, Eye::kLeft);
  ExpectNear(X_BCl.translation(), 0.05, 0.04, 0.30);
  ExpectNear(X_BCl.linear().col(0), 0, -1, 0);  // image right is the robot's right
  ExpectNear(X_BCl.linear().col(1), 0, 0, -1);  // image down is down
  ExpectNear(X_BCl.linear().col(2), 1, 0, 0);
  ExpectNear(EyePose(KoalaHead(), {}, Eye::kRight).translation(), 0.05, -0.04, 0.30);
}

TEST(HeadKinematics, PanIsPositiveToTheLeftAndTiltPositiveDown) {
  HeadAngles angles;
  angles.left.pan_rad = M_PI / 6;
  ExpectNear(EyePose(KoalaHead(), angles, Eye::kLeft).linear().col(2), std::sqrt(3) / 2, 0.5, 0);
  ExpectNear(EyePose(KoalaHead(), angles, Eye::kRight).linear().col(2), 1, 0, 0);
  angles = {};
  angles.right.tilt_rad = M_PI / 6;
  ExpectNear(EyePose(KoalaHead(), angles, Eye::kRight).linear().col(2), std::sqrt(3) / 2, 0, -0.5);
}

TEST(HeadKinematics, PanComesBeforeTilt) {
  HeadAngles angles;
  angles.left = {M_PI / 2, M_PI / 4};
  const Pose X_BC = EyePose(KoalaHead(), angles, Eye::kLeft);
  ExpectNear(X_BC.linear().col(2), 0, std::sqrt(0.5), -std::sqrt(0.5));
  ExpectNear(X_BC.linear().col(0), 1, 0, 0);  // stays level: tilt has no roll
}

TEST(HeadKinematics, EveryLeverArmCounts) {
  const HeadGeometry g = YorickHead();
  HeadAngles angles;
  ExpectNear(EyePose(g, angles, Eye::kLeft).translation(), 0.10 + 0.03, 0.02 + 0.1625, 0.90);

  // Neck looking straight down: the eyes stand forward of the tilt axis, the lens below it.
  angles.neck.tilt_rad = M_PI / 2;
  ExpectNear(HeadPose(g, angles.neck).translation(), 0.10 + 0.04, 0.02, 0.86);
  ExpectNear(EyePose(g, angles, Eye::kLeft).translation(), 0.14, 0.02 + 0.1625, 0.86 - 0.03);

  // Neck to the left: the left eye moves back, the lenses point to +y.
  angles.neck = {M_PI / 2, 0};
  ExpectNear(EyePose(g, angles, Eye::kLeft).translation(), 0.10 - 0.1625, 0.02 + 0.03, 0.90);
  ExpectNear(EyePose(g, angles, Eye::kRight).translation(), 0.10 + 0.1625, 0.02 + 0.03, 0.90);

  // An eye's own vergence carries its optical centre round its axis.
  angles = {};
  angles.left.pan_rad = -M_PI / 2;
  ExpectNear(EyePose(g, angles, Eye::kLeft).translation(), 0.10, 0.02 + 0.1625 - 0.03, 0.90);
}

TEST(HeadKinematics, NeckTurnsBothEyesTogether) {
  HeadAngles angles;
  angles.left = {-0.1, 0.2};
  angles.right = {0.15, 0.1};
  const Pose before = RightEyeInLeft(YorickHead(), angles);
  angles.neck = {0.7, -0.3};
  EXPECT_TRUE(RightEyeInLeft(YorickHead(), angles).isApprox(before, 1e-12));
}

TEST(HeadKinematics, ParallelRigSeesTheBaselineAlongItsXAxis) {
  ExpectNear(RightEyeInLeft(KoalaHead(), {}).translation(), 0.08, 0, 0);
}

TEST(HeadKinematics, AxesThatMissEachOtherGiveTheGapBetweenThem) {
  // Eyes tilted apart by the same angle and verged: by symmetry the axes come nearest in the
  // plane y = 0 at height 0.30, half the gap above and below it.
  HeadAngles angles;
  angles.left = {-0.1, 0.02};
  angles.right = {0.1, -0.02};
  const auto point = FindFixationPoint(KoalaHead(), angles);
  ASSERT_TRUE(point.has_value());
  EXPECT_NEAR(point->p_B.y(), 0, 1e-12);
  EXPECT_NEAR(point->p_B.z(), 0.30, 1e-12);
  const Pose X_BCl = EyePose(KoalaHead(), angles, Eye::kLeft);
  const Pose X_BCr = EyePose(KoalaHead(), angles, Eye::kRight);
  double least = std::numeric_limits<double>::infinity();
  for (double s = 0.2; s < 0.6; s += 0.001) {
    const Eigen::Vector3d on_left = X_BCl.translation() + s * X_BCl.linear().col(2);
    const Eigen::Vector3d d = on_left - X_BCr.translation();
    least = std::min(least, d.cross(X_BCr.linear().col(2)).norm());
  }
  EXPECT_NEAR(point->gap_m, least, 1e-6);
  EXPECT_GT(point->gap_m, 0.01);
}

TEST(HeadKinematics, ParallelAndDivergingAxesMeetNowhere) {
  EXPECT_FALSE(FindFixationPoint(KoalaHead(), {}).has_value());
  HeadAngles diverging;
  diverging.left.pan_rad = 0.1;
  diverging.right.pan_rad = -0.1;
  EXPECT_FALSE(FindFixationPoint(KoalaHead(), diverging).has_value());
}

TEST(HeadKinematics, ValidateNamesEveryBadField) {
  EXPECT_TRUE(Validate(KoalaHead()).empty());
  HeadGeometry bad = KoalaHead();
  bad.baseline_m = 0;
  bad.pan_to_tilt_m = -1;
  bad.tilt_to_eyes_m = std::numeric_limits<double>::quiet_NaN();
  bad.X_BN.linear() *= 2;
  std::vector<std::string> fields;
  for (const auto& e : Validate(bad)) fields.push_back(e.field);
  EXPECT_THAT(fields, testing::UnorderedElementsAre("head.baseline_m", "head.pan_to_tilt_m",
                                                    "head.tilt_to_eyes_m", "head.X_BN"));
}

}  // namespace
}  // namespace horopter::control
