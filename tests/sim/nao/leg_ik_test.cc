// SPDX-License-Identifier: Apache-2.0
#include "sim/nao/leg_ik.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "sim/world/world.h"

namespace horopter::sim {
namespace {

using hardware::Eye;
using hardware::Pose;

/// A foot at a place under its hip, turned by a heading.
Pose Foot(Eye side, double x, double y, double up, double heading) {
  const double sign = side == Eye::kLeft ? 1 : -1;
  Pose X = Pose::Identity();
  X.translation() << x, sign * NaoLeg::kHipAside_m + y, -NaoLeg::kHipBelow_m - 0.187 + up;
  X.linear() = Eigen::AngleAxisd(heading, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  return X;
}

TEST(LegIk, FootIsWhereItWasAskedFor) {
  for (const Eye side : hardware::kBothEyes) {
    for (const double heading : {-0.3, 0.0, 0.35}) {
      for (const double x : {-0.04, 0.0, 0.05}) {
        for (const double y : {-0.02, 0.03}) {
          for (const double up : {0.0, 0.02}) {
            const Pose X_TF = Foot(side, x, y, up, heading);
            const LegAngles leg = SolveLeg(side, X_TF, SolveHipYawPitch(side, X_TF));
            EXPECT_TRUE(LegForward(side, leg).isApprox(X_TF, 1e-7))
                << ToString(side) << " " << heading << " " << x << " " << y << " " << up;
          }
        }
      }
    }
  }
}

TEST(LegIk, WithTheOtherLegsHipTheFootStaysOnThePlaneInItsPlace) {
  const Pose X_TF = Foot(Eye::kRight, 0.02, -0.01, 0, 0);
  const Pose got = LegForward(Eye::kRight, SolveLeg(Eye::kRight, X_TF, -0.3));
  EXPECT_LT((got.translation() - X_TF.translation()).norm(), 1e-9);
  EXPECT_NEAR(got.linear()(2, 2), 1, 1e-9);
  EXPECT_GT(std::abs(hardware::ToPose2(got).heading_rad), 0.1);
}

TEST(LegIk, OutOfReachGivesAStraightLegTowardsTheFoot) {
  const LegAngles leg = SolveLeg(Eye::kLeft, Foot(Eye::kLeft, 0.1, 0, -0.2, 0), 0);
  EXPECT_NEAR(leg.knee_pitch, 0, 1e-6);
  EXPECT_TRUE(std::isfinite(leg.hip_pitch) && std::isfinite(leg.ankle_pitch));
}

/// The model's joints, axes and lengths are the ones that the kinematics has.
TEST(LegIk, ForwardKinematicsIsTheScenes) {
  World world(std::string(HOROPTER_SOURCE_DIR) + "/scenes/nao/workspace.xml");
  const auto set = [&world](const std::string& joint, double angle) {
    const int id = world.Id(mjOBJ_JOINT, joint);
    world.mutable_data().qpos[world.model().jnt_qposadr[id]] = angle;
  };
  for (const double scale : {0.0, 0.4, -0.3, 1.0}) {
    const LegAngles leg{-0.4 * scale, 0.2 * scale, -0.6 * scale, 0.9, -0.5 * scale, 0.15 * scale};
    for (const Eye side : hardware::kBothEyes) {
      const std::string letter = side == Eye::kLeft ? "L" : "R";
      set(letter + "HipYawPitch", leg.hip_yaw_pitch);
      set(letter + "HipRoll", leg.hip_roll);
      set(letter + "HipPitch", leg.hip_pitch);
      set(letter + "KneePitch", leg.knee_pitch);
      set(letter + "AnklePitch", leg.ankle_pitch);
      set(letter + "AnkleRoll", leg.ankle_roll);
    }
    world.Forward();
    const Pose X_TW = world.X_WBody("torso").inverse();
    EXPECT_TRUE((X_TW * world.X_WBody("l_foot")).isApprox(LegForward(Eye::kLeft, leg), 1e-7));
    EXPECT_TRUE((X_TW * world.X_WBody("r_foot")).isApprox(LegForward(Eye::kRight, leg), 1e-7));
  }
}

}  // namespace
}  // namespace horopter::sim
