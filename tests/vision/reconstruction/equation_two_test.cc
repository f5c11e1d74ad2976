// SPDX-License-Identifier: Apache-2.0
#include "vision/reconstruction/equation_two.h"

#include <gtest/gtest.h>

#include <Eigen/SVD>
#include <random>

#include "tests/vision/reconstruction/verged_pair.h"

namespace horopter::vision {
namespace {

using hardware::Eye;
using hardware::PanTilt;

TEST(EquationTwo, PaperAxesAreRightUpBackward) {
  const Eigen::Matrix3d R = PaperToBody();
  EXPECT_EQ(R * Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, -1, 0));
  EXPECT_EQ(R * Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(0, 0, 1));
  EXPECT_EQ(R * Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(-1, 0, 0));
  EXPECT_DOUBLE_EQ(R.determinant(), 1);
}

TEST(EquationTwo, AlphaIsPositiveToTheRightAndBetaDown) {
  const PaperEye left_turn = EyeFromAngles({0.3, 0}, Eye::kLeft, 0.1);
  EXPECT_LT(left_turn.forward.x(), 0);  // pan to the left is a negative alpha
  const PaperEye down = EyeFromAngles({0, 0.3}, Eye::kLeft, 0.1);
  EXPECT_LT(down.forward.y(), 0);
  EXPECT_DOUBLE_EQ(down.centre.x(), -0.05);
  EXPECT_DOUBLE_EQ(EyeFromAngles({}, Eye::kRight, 0.1).centre.x(), 0.05);
}

TEST(EquationTwo, AnglesAndPosesGiveTheSameEye) {
  for (const double pan : {-0.6, 0.0, 0.4}) {
    for (const double tilt : {-0.3, 0.0, 0.5}) {
      for (const Eye eye : hardware::kBothEyes) {
        const PaperEye a = EyeFromAngles({pan, tilt}, eye, 0.08);
        const PaperEye b = EyeFromPose(EyeInHead({pan, tilt}, eye, 0.08));
        EXPECT_LT((a.right - b.right).norm(), 1e-14);
        EXPECT_LT((a.up - b.up).norm(), 1e-14);
        EXPECT_LT((a.forward - b.forward).norm(), 1e-14);
        EXPECT_LT((a.centre - b.centre).norm(), 1e-14);
      }
    }
  }
}

TEST(EquationTwo, RowsAreThoseOfThePaper) {
  // Equation (2) written out for the left eye, with f0 = 1.
  const double alpha = 0.2, beta = -0.15, b = 0.1, x = 0.3, y = -0.2;
  const PaperEye left = EyeFromAngles({-alpha, beta}, Eye::kLeft, b);
  const PaperEye right = EyeFromAngles({}, Eye::kRight, b);
  const EquationTwo system = MakeEquationTwo(left, {x, y}, right, {0, 0});
  const double sa = sin(alpha), ca = cos(alpha), sb = sin(beta), cb = cos(beta);
  EXPECT_NEAR(system.A(0, 0), x * sa * cb - ca, 1e-15);
  EXPECT_NEAR(system.A(0, 1), -x * sb, 1e-15);
  EXPECT_NEAR(system.A(0, 2), -x * ca * cb - sa, 1e-15);
  EXPECT_NEAR(system.b(0), -x * b * sa * cb / 2 + b * ca / 2, 1e-15);
  EXPECT_NEAR(system.A(1, 0), y * sa * cb - sa * sb, 1e-15);
  EXPECT_NEAR(system.A(1, 1), -cb - y * sb, 1e-15);
  EXPECT_NEAR(system.A(1, 2), ca * sb - y * ca * cb, 1e-15);
  EXPECT_NEAR(system.b(1), -y * sa * cb * b / 2 + sa * sb * b / 2, 1e-15);
}

TEST(EquationTwo, NormalEquationsAgreeWithSvdOnRaysThatMissEachOther) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> angle(-0.4, 0.4), image(-0.5, 0.5), noise(-2e-3, 2e-3);
  for (int i = 0; i < 500; ++i) {
    const PaperEye left = EyeFromAngles({angle(generator), angle(generator)}, Eye::kLeft, 0.1);
    const PaperEye right = EyeFromAngles({angle(generator), angle(generator)}, Eye::kRight, 0.1);
    const Eigen::Vector3d F(image(generator), image(generator), -1.5 + image(generator));
    const auto project = [&](const PaperEye& e) {
      const Eigen::Vector3d d = F - e.centre;
      return Eigen::Vector2d(e.right.dot(d) / e.forward.dot(d) + noise(generator),
                             e.up.dot(d) / e.forward.dot(d) + noise(generator));
    };
    const Eigen::Vector2d at_left = project(left);
    const EquationTwo system = MakeEquationTwo(left, at_left, right, project(right));
    const Eigen::Vector3d svd =
        Eigen::JacobiSVD<Eigen::MatrixXd>(system.A, Eigen::ComputeThinU | Eigen::ComputeThinV)
            .solve(system.b);
    EXPECT_LT((SolveNormalEquations(system) - svd).norm(), 1e-9);
  }
}

TEST(EquationTwo, ParallelRaysHaveNoFiniteSolution) {
  const EquationTwo system = MakeEquationTwo(EyeFromAngles({}, Eye::kLeft, 0.1), {0, 0},
                                             EyeFromAngles({}, Eye::kRight, 0.1), {0, 0});
  EXPECT_FALSE(SolveNormalEquations(system).allFinite());
}

}  // namespace
}  // namespace horopter::vision
