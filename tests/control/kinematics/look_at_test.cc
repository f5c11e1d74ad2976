// SPDX-License-Identifier: Apache-2.0
#include "control/kinematics/look_at.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "control/kinematics/head_kinematics.h"
#include "hardware/types/config_error.h"
#include "tests/control/kinematics/heads.h"

namespace horopter::control {
namespace {

using hardware::Eye;
using hardware::HeadAngles;
using hardware::HeadAxis;
using hardware::HeadGeometry;
using hardware::HeadLimits;
using hardware::Pose;

constexpr double kDegree = M_PI / 180;

/// Every lever arm of the four-axis model differs from zero, and the neck stands askew.
HeadGeometry FourAxisHead() {
  HeadGeometry g = YorickHead();
  g.pan_to_tilt_forward_m = 0.05;
  g.X_BN.linear() = Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 2, 3).normalized()).matrix();
  return g;
}

double Clamped(double angle, const hardware::AxisLimits& axis) {
  return std::clamp(angle, axis.min_rad, axis.max_rad);
}

void ExpectWithin(const HeadLimits& limits, const HeadAngles& angles) {
  const auto all = hardware::ToArray(angles);
  for (int i = 0; i < hardware::kHeadAxisCount; ++i) {
    EXPECT_EQ(all[i], Clamped(all[i], limits[i])) << hardware::kHeadAxisNames[i];
  }
}

/// How far the target is from the line along an optical axis; huge when behind the eye.
double MissOfAxis(const Pose& X_BC, const Eigen::Vector3d& p_BT) {
  const Eigen::Vector3d p_CT = X_BC.inverse() * p_BT;
  return p_CT.z() > 0 ? p_CT.head<2>().norm() : std::numeric_limits<double>::infinity();
}

void ExpectBothAxesThrough(const HeadGeometry& g, const Fixation& f, const Eigen::Vector3d& p_BT) {
  for (const Eye eye : hardware::kBothEyes) {
    EXPECT_LT(MissOfAxis(EyePose(g, f.angles, eye), p_BT), 1e-9)
        << hardware::ToString(eye) << " " << p_BT.transpose();
  }
}

/// Angles anywhere within the limits.
HeadAngles DrawAngles(std::mt19937_64& random, const HeadLimits& limits) {
  hardware::HeadAxisArray angles{};
  for (int i = 0; i < hardware::kHeadAxisCount; ++i) {
    std::uniform_real_distribution<double> axis(limits[i].min_rad, limits[i].max_rad);
    if (limits[i].exists()) angles[i] = axis(random);
  }
  return hardware::FromArray(angles);
}

TEST(LookAt, ReachesWhateverAnyAnglesWithinTheLimitsFixate) {
  std::mt19937_64 random(1);
  const HeadGeometry g = FourAxisHead();
  const HeadLimits limits = YorickLimits();
  int reached = 0;
  int by_the_eyes = 0;
  for (int i = 0; i < 20000; ++i) {
    const HeadAngles from = DrawAngles(random, limits);
    const auto point = FindFixationPoint(g, from);
    // Nearer than the model describes, or so far that an angle's last bit moves it by 1e-9 m.
    if (!point || point->p_B.norm() > 20) continue;
    const Fixation f = LookAt(g, limits, point->p_B);
    if (f.fault == FixationFault::kTooClose) {
      EXPECT_LT((point->p_B - HeadPose(g, from.neck).translation()).norm(), g.baseline_m);
      continue;
    }
    ASSERT_TRUE(f.reachable()) << f.why << "\n" << point->p_B.transpose();
    ExpectWithin(limits, f.angles);
    ExpectBothAxesThrough(g, f, point->p_B);
    by_the_eyes += f.angles.left.pan_rad != -f.angles.right.pan_rad;
    ++reached;
  }
  EXPECT_GT(reached, 15000);
  EXPECT_GT(by_the_eyes, 10);  // beyond the neck's pan
}

TEST(LookAt, GivesBackTheAnglesThatFixateWhenTheNecksPanIsKept) {
  std::mt19937_64 random(2);
  const HeadGeometry g = FourAxisHead();
  const HeadLimits limits = YorickLimits();
  int checked = 0;
  for (int i = 0; i < 5000; ++i) {
    const HeadAngles from = DrawAngles(random, limits);
    const auto point = FindFixationPoint(g, from);
    if (!point || point->p_B.norm() > 5) continue;
    const Fixation f = LookAt(g, limits, point->p_B, {.neck_pan_rad = from.neck.pan_rad});
    if (!f.reachable()) continue;
    const auto expected = hardware::ToArray(from), actual = hardware::ToArray(f.angles);
    for (int axis = 0; axis < hardware::kHeadAxisCount; ++axis) {
      EXPECT_NEAR(actual[axis], expected[axis], 1e-9) << hardware::kHeadAxisNames[axis];
    }
    ++checked;
  }
  EXPECT_GT(checked, 3000);
}

TEST(LookAt, SymmetricVergenceWheneverTheNeckCanTurnThatFar) {
  const HeadGeometry g = YorickHead();
  for (double azimuth = -85 * kDegree; azimuth < 86 * kDegree; azimuth += 10 * kDegree) {
    const Eigen::Vector3d p_BT =
        g.X_BN * Eigen::Vector3d(1.1 * std::cos(azimuth), 1.1 * std::sin(azimuth), -0.3);
    const Fixation f = LookAt(g, YorickLimits(), p_BT);
    ASSERT_TRUE(f.reachable()) << f.why;
    EXPECT_NEAR(f.angles.neck.pan_rad, azimuth, 1e-12);
    EXPECT_EQ(f.angles.left.pan_rad, -f.angles.right.pan_rad);
    EXPECT_LT(f.angles.left.pan_rad, 0);   // the left eye turns right
    EXPECT_GT(f.angles.neck.tilt_rad, 0);  // down
  }
}

TEST(LookAt, ElevationAxisAheadOfThePanAxisCounts) {
  // P = 1, C = 3: a target 6 ahead of the pan axis is 5 from the elevation axis, so 4 from H.
  HeadGeometry g;
  g.pan_to_tilt_forward_m = 1;
  g.tilt_to_eyes_m = 3;
  g.baseline_m = 2;
  const Fixation f = LookAt(g, YorickLimits(), {6, 0, 0});
  ASSERT_TRUE(f.reachable()) << f.why;
  EXPECT_NEAR(f.angles.neck.tilt_rad, std::asin(3.0 / 5), 1e-12);
  EXPECT_NEAR(f.angles.right.pan_rad, std::atan2(1.0, 4.0), 1e-12);
  const HeadGeometry flat = YorickHead();
  HeadGeometry ahead = flat;
  ahead.pan_to_tilt_forward_m = 0.05;
  const Eigen::Vector3d moved = HeadPose(ahead, {M_PI / 2, 0.2}).translation() -
                                HeadPose(flat, {M_PI / 2, 0.2}).translation();
  EXPECT_LT((moved - Eigen::Vector3d(0, 0.05, 0)).norm(), 1e-12);
}

TEST(LookAt, ParallelAxesStayParallelWithTheTargetMidwayBetweenThem) {
  const HeadGeometry g = FourAxisHead();
  HeadLimits limits = YorickLimits();
  for (const HeadAxis axis : {HeadAxis::kLeftPan, HeadAxis::kRightPan}) {
    limits[static_cast<int>(axis)] = {-0.8, 0.8, 8, 80};
  }
  for (const std::optional<double> neck : {std::optional<double>(), std::optional<double>(0.2)}) {
    for (double y = -1; y <= 1; y += 0.25) {
      const Eigen::Vector3d p_BT = g.X_BN * Eigen::Vector3d(2, y, -0.4);
      const Fixation f = LookAt(g, limits, p_BT, {Gaze::kParallel, neck});
      ASSERT_TRUE(f.reachable()) << f.why;
      const Pose X_BCl = EyePose(g, f.angles, Eye::kLeft),
                 X_BCr = EyePose(g, f.angles, Eye::kRight);
      EXPECT_LT((X_BCl.linear() - X_BCr.linear()).norm(), 1e-12);
      Pose middle = X_BCl;
      middle.translation() = (X_BCl.translation() + X_BCr.translation()) / 2;
      EXPECT_LT(MissOfAxis(middle, p_BT), 1e-9);
      EXPECT_EQ(f.angles.left.pan_rad == 0, !neck.has_value());
    }
  }
}

TEST(LookAt, ParallelGazeReachesWhatIsTooCloseToConvergeOn) {
  const HeadGeometry g = YorickHead();
  const Eigen::Vector3d p_BT = g.X_BN * Eigen::Vector3d(0.12, 0, 0.1);
  EXPECT_EQ(LookAt(g, YorickLimits(), p_BT).fault, FixationFault::kTooClose);
  EXPECT_TRUE(LookAt(g, YorickLimits(), p_BT, {.gaze = Gaze::kParallel}).reachable());
}

TEST(LookAt, EyesMakeUpForANeckThatCannotTurnSoFarUntilTheyCannotEither) {
  const HeadGeometry g = YorickHead();
  const auto at_azimuth = [&](double azimuth_deg) {
    const double a = azimuth_deg * kDegree;
    return Eigen::Vector3d(g.X_BN * Eigen::Vector3d(0.8 * std::cos(a), 0.8 * std::sin(a), -0.1));
  };
  const Fixation beyond = LookAt(g, YorickLimits(), at_azimuth(95));
  EXPECT_TRUE(beyond.reachable()) << beyond.why;
  EXPECT_EQ(beyond.angles.neck.pan_rad, 90 * kDegree);
  ExpectBothAxesThrough(g, beyond, at_azimuth(95));
  const Fixation too_far = LookAt(g, YorickLimits(), at_azimuth(120));
  EXPECT_EQ(too_far.fault, FixationFault::kBeyondLimits);
  EXPECT_EQ(too_far.axis, HeadAxis::kNeckPan);
  EXPECT_NE(too_far.why.find("neck_pan would have to be 120.00 deg"), std::string::npos)
      << too_far.why;
  ExpectWithin(YorickLimits(), too_far.angles);
  HeadLimits narrow = YorickLimits();
  narrow[static_cast<int>(HeadAxis::kNeckPan)] = {-0.8, 0.8, 8, 80};
  EXPECT_EQ(LookAt(g, narrow, at_azimuth(150)).fault, FixationFault::kBehind);
}

TEST(LookAt, NamesTheElevationThatIsMissing) {
  const HeadGeometry g = YorickHead();
  const Fixation f = LookAt(g, YorickLimits(), g.X_BN * Eigen::Vector3d(0.5, 0.2, -1.5));
  EXPECT_EQ(f.fault, FixationFault::kBeyondLimits);
  EXPECT_EQ(f.axis, HeadAxis::kNeckTilt);
  EXPECT_EQ(f.angles.neck.tilt_rad, 40 * kDegree);
  ExpectWithin(YorickLimits(), f.angles);
}

TEST(LookAt, AHeadWithoutEyeAxesSaysWhenItsNeckDoesNotTurnSoFar) {
  HeadLimits limits = YorickLimits();
  limits[static_cast<int>(HeadAxis::kLeftPan)] = {};
  limits[static_cast<int>(HeadAxis::kRightPan)] = {};
  const HeadGeometry g = YorickHead();
  EXPECT_TRUE(LookAt(g, limits, g.X_BN * Eigen::Vector3d(1, 1, 0)).reachable());
  const Fixation f = LookAt(g, limits, g.X_BN * Eigen::Vector3d(-0.1, 1, 0));
  EXPECT_EQ(f.axis, HeadAxis::kNeckPan);
  EXPECT_FALSE(
      LookAt(g, limits, g.X_BN * Eigen::Vector3d(1, 1, 0), {.neck_pan_rad = 0.3}).reachable());
}

TEST(LookAt, RefusesTargetsThatAreNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(LookAt(YorickHead(), YorickLimits(), {1, nan, 0}).fault, FixationFault::kNotFinite);
}

TEST(ForPair, APairThatIsMountedHigherAndFartherAheadLooksFromThere) {
  const HeadGeometry fovea = FourAxisHead();
  const HeadGeometry peripheral = ForPair(fovea, {.above_m = 0.034, .ahead_m = -0.012});
  const Eigen::Vector3d p_BT = fovea.X_BN * Eigen::Vector3d(1.2, 0.3, -0.4);
  for (const HeadAngles& angles : {LookAt(fovea, YorickLimits(), p_BT).angles, HeadAngles{}}) {
    for (const Eye eye : hardware::kBothEyes) {
      const Pose between = EyePose(fovea, angles, eye).inverse() * EyePose(peripheral, angles, eye);
      EXPECT_TRUE(between.linear().isIdentity(1e-12));
      EXPECT_LT((between.translation() - Eigen::Vector3d(0, -0.034, -0.012)).norm(), 1e-12);
    }
  }
  const Fixation f = LookAt(peripheral, YorickLimits(), p_BT);
  ASSERT_TRUE(f.reachable()) << f.why;
  ExpectBothAxesThrough(peripheral, f, p_BT);
  EXPECT_GT(MissOfAxis(EyePose(fovea, f.angles, Eye::kLeft), p_BT), 0.03);
  EXPECT_THROW(ForPair(fovea, {.ahead_m = -0.1}), hardware::ConfigError);
}

}  // namespace
}  // namespace horopter::control
