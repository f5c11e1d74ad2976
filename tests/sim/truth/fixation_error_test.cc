// SPDX-License-Identifier: Apache-2.0
#include "sim/truth/fixation_error.h"

#include <gtest/gtest.h>

#include <cmath>

namespace horopter::sim {
namespace {

using hardware::Pose;

/// At a place, turned left by pan and down by tilt.
Pose EyePose(const Eigen::Vector3d& p_WC, double pan, double tilt) {
  Pose X = Pose::Identity();
  X.translation() = p_WC;
  X.linear() = (Eigen::AngleAxisd(pan, Eigen::Vector3d::UnitZ()) *
                Eigen::AngleAxisd(tilt, Eigen::Vector3d::UnitY()))
                   .toRotationMatrix() *
               hardware::OpticalToBody();
  return X;
}

TEST(FixationError, IsTheAngleTheEyeIsOff) {
  const Eigen::Vector3d centre(0.1, -0.2, 0.3);
  for (const double off : {0.0, 1e-9, 1e-3, 0.5, 1.5, 3.0}) {
    const Eigen::Vector3d target = centre + 2.5 * Eigen::Vector3d(std::cos(off), std::sin(off), 0);
    EXPECT_NEAR(FixationError(EyePose(centre, 0, 0), target), off, 1e-12);
    EXPECT_NEAR(FixationError(EyePose(centre, off, 0), target), 0, 1e-12);
  }
  EXPECT_NEAR(FixationError(EyePose(centre, 0, 0.2), centre + Eigen::Vector3d(3, 0, 0)), 0.2,
              1e-12);
}

TEST(FixationError, HasNoValueAtTheOpticalCentre) {
  EXPECT_TRUE(std::isnan(FixationError(EyePose({1, 2, 3}, 0.3, 0.1), {1, 2, 3})));
}

TEST(FixationError, OfBothEyesOfATruth) {
  const hardware::CameraModel camera = hardware::CameraModel::FromHorizontalFov(4, 4, 1);
  const EyeView left{EyePose({0, 0.1, 0}, -std::atan2(0.1, 1.0), 0), camera};
  const EyeView right{EyePose({0, -0.1, 0}, 0, 0), camera};
  const GroundTruth truth{{}, {left, {}, {}, {}}, {right, {}, {}, {}}};
  const auto error = FixationError(truth, {1, 0, 0});
  EXPECT_NEAR(error.left, 0, 1e-12);
  EXPECT_NEAR(error.right, std::atan2(0.1, 1.0), 1e-12);
}

}  // namespace
}  // namespace horopter::sim
