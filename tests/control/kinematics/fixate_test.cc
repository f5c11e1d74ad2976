// SPDX-License-Identifier: Apache-2.0
#include "control/kinematics/fixate.h"

#include <gtest/gtest.h>

#include <limits>

#include "control/kinematics/head_kinematics.h"
#include "tests/control/kinematics/heads.h"

namespace horopter::control {
namespace {

using hardware::Eye;
using hardware::HeadAngles;
using hardware::HeadAxis;
using hardware::HeadGeometry;
using hardware::HeadLimits;

/// Both optical axes pass through the target, and the fixation point found from the angles is it.
void ExpectFixates(const HeadGeometry& g, const HeadAngles& angles, const Eigen::Vector3d& p_BT) {
  for (const Eye eye : hardware::kBothEyes) {
    const Eigen::Vector3d p_CT = EyePose(g, angles, eye).inverse() * p_BT;
    EXPECT_LT(p_CT.head<2>().norm(), 1e-12) << hardware::ToString(eye) << p_BT.transpose();
    EXPECT_GT(p_CT.z(), 0) << hardware::ToString(eye) << p_BT.transpose();
  }
  const auto back = FindFixationPoint(g, angles);
  ASSERT_TRUE(back.has_value()) << p_BT.transpose();
  EXPECT_LT((back->p_B - p_BT).norm(), 1e-9) << p_BT.transpose();
  EXPECT_LT(back->gap_m, 1e-9);
}

TEST(FixateWithEyes, RoundTripOverAGridOfTargets) {
  HeadGeometry g = KoalaHead();
  for (const double lever : {0.0, 0.02}) {
    g.axis_to_optical_centre_m = lever;
    for (double x = 0.2; x < 4; x *= 1.5) {
      for (double y = -0.6; y <= 0.6; y += 0.3) {
        for (double z = 0; z <= 0.6; z += 0.15) {
          const Eigen::Vector3d p_BT(x + 0.05, y * x, 0.3 + (z - 0.3) * x);
          for (const hardware::PanTilt neck : {hardware::PanTilt{}, {0.2, -0.1}}) {
            const Fixation f = FixateWithEyes(g, KoalaLimits(), neck, p_BT);
            ASSERT_TRUE(f.reachable()) << f.why;
            EXPECT_EQ(f.angles.neck.pan_rad, neck.pan_rad);
            ExpectFixates(g, f.angles, p_BT);
          }
        }
      }
    }
  }
}

TEST(FixateWithNeck, RoundTripOverAGridOfTargets) {
  const HeadGeometry g = YorickHead();
  int checked = 0;
  for (double range = 0.4; range < 6; range *= 1.5) {
    for (double azimuth = -1.5; azimuth <= 1.5; azimuth += 0.5) {
      for (double up = -0.5; up <= 0.5; up += 0.25) {
        const Eigen::Vector3d p_BT =
            g.X_BN * Eigen::Vector3d(range * std::cos(azimuth), range * std::sin(azimuth),
                                     range * std::tan(up) + g.pan_to_tilt_m);
        const Fixation f = FixateWithNeck(g, YorickLimits(), p_BT);
        ASSERT_TRUE(f.reachable()) << f.why;
        ExpectFixates(g, f.angles, p_BT);
        EXPECT_EQ(f.angles.left.pan_rad, -f.angles.right.pan_rad);
        EXPECT_NEAR(f.angles.neck.pan_rad, azimuth, 1e-12);
        ++checked;
      }
    }
  }
  EXPECT_GT(checked, 200);
}

TEST(FixateWithEyes, SignsOfTheFourDirections) {
  const auto at = [](double x, double y, double z) {
    return FixateWithEyes(KoalaHead(), KoalaLimits(), {}, {x, y, z}).angles;
  };
  const HeadAngles ahead = at(1, 0, 0.3);
  EXPECT_LT(ahead.left.pan_rad, 0);  // converging: the left eye turns right
  EXPECT_GT(ahead.right.pan_rad, 0);
  EXPECT_NEAR(ahead.left.tilt_rad, 0, 1e-12);
  EXPECT_GT(at(1, 0.5, 0.3).left.pan_rad, 0);
  EXPECT_LT(at(1, -0.5, 0.3).right.pan_rad, 0);
  EXPECT_GT(at(1, 0, 0.0).left.tilt_rad, 0);
  EXPECT_LT(at(1, 0, 0.6).right.tilt_rad, 0);
}

TEST(FixateWithNeck, KnownCase) {
  // The eyes' plane is a lever of 3 above the tilt axis; a target 5 away is 4 in front of it.
  HeadGeometry g;
  g.pan_to_tilt_m = 1;
  g.tilt_to_eyes_m = 3;
  g.baseline_m = 2;
  HeadLimits limits = YorickLimits();
  limits[static_cast<int>(HeadAxis::kNeckTilt)] = {-2, 2, 1, 1};
  const Fixation f = FixateWithNeck(g, limits, {0, 5, 1});
  EXPECT_EQ(f.fault, FixationFault::kBehind);  // exactly abeam counts as behind
  const Fixation ahead = FixateWithNeck(g, limits, {5, 0, 1});
  ASSERT_TRUE(ahead.reachable()) << ahead.why;
  EXPECT_NEAR(ahead.angles.neck.tilt_rad, std::asin(3.0 / 5), 1e-12);
  EXPECT_NEAR(ahead.angles.right.pan_rad, std::atan2(1.0, 4.0), 1e-12);
}

TEST(Fixate, HeadWithoutEyeAxesAimsItsMiddle) {
  HeadGeometry nao = YorickHead();
  nao.axis_to_optical_centre_m = 0;
  HeadLimits limits = YorickLimits();
  limits[static_cast<int>(HeadAxis::kLeftPan)] = {};
  limits[static_cast<int>(HeadAxis::kRightPan)] = {};
  const Eigen::Vector3d p_BT(1.5, 0.4, 0.5);
  const Fixation f = Fixate(nao, limits, {}, p_BT);
  ASSERT_TRUE(f.reachable()) << f.why;
  EXPECT_EQ(f.angles.left.pan_rad, 0);
  const Eigen::Vector3d p_HT = HeadPose(nao, f.angles.neck).inverse() * p_BT;
  EXPECT_LT(p_HT.tail<2>().norm(), 1e-12);
}

TEST(Fixate, ChoosesByTheAxesThatExist) {
  const Eigen::Vector3d p_BT(2, 0.5, 0.4);
  EXPECT_EQ(Fixate(KoalaHead(), KoalaLimits(), {}, p_BT).angles.neck.pan_rad, 0);
  EXPECT_NE(Fixate(YorickHead(), YorickLimits(), {}, p_BT).angles.neck.pan_rad, 0);
}

TEST(Fixate, SaysWhyATargetIsOutOfReach) {
  const Fixation behind = Fixate(KoalaHead(), KoalaLimits(), {}, {-1, 0, 0.3});
  EXPECT_EQ(behind.fault, FixationFault::kBehind);
  EXPECT_NE(behind.why.find("(-1.000, 0.000, 0.300)"), std::string::npos) << behind.why;

  EXPECT_EQ(Fixate(KoalaHead(), KoalaLimits(), {}, {0.06, 0, 0.3}).fault, FixationFault::kTooClose);
  EXPECT_EQ(Fixate(YorickHead(), YorickLimits(), {}, {0.2, 0.02, 0.9}).fault,
            FixationFault::kTooClose);

  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(Fixate(YorickHead(), YorickLimits(), {}, {1, nan, 0}).fault, FixationFault::kNotFinite);
}

TEST(Fixate, NamesTheAxisBeyondItsLimitsAndLooksAsFarAsItCan) {
  const Fixation f = Fixate(KoalaHead(), KoalaLimits(), {}, {0.15, 0, 1.3});
  EXPECT_EQ(f.fault, FixationFault::kBeyondLimits);
  EXPECT_EQ(f.axis, HeadAxis::kLeftTilt);
  EXPECT_NE(f.why.find("left_tilt"), std::string::npos) << f.why;
  EXPECT_EQ(f.angles.left.tilt_rad, -0.8);
  EXPECT_LT(f.angles.left.pan_rad, 0);  // the axes within their limits still aim

  HeadLimits narrow = YorickLimits();
  narrow[static_cast<int>(HeadAxis::kLeftPan)].min_rad = -0.5;
  const Fixation near = Fixate(YorickHead(), narrow, {}, {0.33, 0.02, 0.9});
  EXPECT_EQ(near.fault, FixationFault::kBeyondLimits) << near.why;
  EXPECT_EQ(near.axis, HeadAxis::kLeftPan);
}

}  // namespace
}  // namespace horopter::control
