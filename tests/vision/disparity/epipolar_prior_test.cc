// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/epipolar_prior.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <opencv2/core.hpp>
#include <random>

#include "textured_pair.h"
#include "vision/disparity/v1_closed_form.h"
#include "vision/disparity/v1_config.h"

namespace horopter::vision {
namespace {

using hardware::CameraModel;
using hardware::Pose;

constexpr double kDeg = M_PI / 180;
const CameraModel kLeft({320, 240, 280, 280, 159.5, 119.5}, {-0.1, 0.02, 0.001, -0.001, 0});
const CameraModel kRight({320, 240, 300, 290, 155, 125});

/// Verged by 6 deg, rolled and a little raised.
RelativePose Verged(double rotation_sigma_rad = 0) {
  RelativePose pose;
  pose.X_ClCr.linear() = (Eigen::AngleAxisd(-6 * kDeg, Eigen::Vector3d::UnitY()) *
                          Eigen::AngleAxisd(1.5 * kDeg, Eigen::Vector3d::UnitZ()))
                             .toRotationMatrix();
  pose.X_ClCr.translation() << 0.08, 0.002, -0.004;
  pose.covariance.diagonal().head<3>().setConstant(rotation_sigma_rad * rotation_sigma_rad);
  return pose;
}

/// A random point that both eyes see, and its disparity.
struct Match {
  int x, y;
  float dx, dy;
};
template <typename Generator>
std::optional<Match> RandomMatch(const Pose& X_ClCr, Generator& random) {
  std::uniform_int_distribution<int> x(0, 319), y(0, 239);
  std::uniform_real_distribution<double> inverse_depth(1 / 20.0, 1 / 0.4);
  const int px = x(random), py = y(random);
  const auto direction = kLeft.Unproject({px, py});
  if (!direction) return std::nullopt;
  const auto q = kRight.Project(X_ClCr.inverse() * (*direction / inverse_depth(random)));
  if (!q || !kRight.Contains(*q)) return std::nullopt;
  return Match{px, py, static_cast<float>(q->x() - px), static_cast<float>(q->y() - py)};
}

TEST(EpipolarPrior, AllowsWhatBothEyesSee) {
  const EpipolarPrior prior(kLeft, kRight, Verged());
  std::mt19937 random(1);
  int seen = 0;
  for (int i = 0; i < 5000; ++i) {
    const auto match = RandomMatch(Verged().X_ClCr, random);
    if (!match) continue;
    ++seen;
    EXPECT_TRUE(prior.Allows(match->x, match->y, match->dx, match->dy))
        << match->x << " " << match->y;
    EXPECT_GE(match->dx, prior.bounds().low_x);
    EXPECT_LE(match->dx, prior.bounds().high_x);
    EXPECT_GE(match->dy, prior.bounds().low_y);
    EXPECT_LE(match->dy, prior.bounds().high_y);
  }
  EXPECT_GT(seen, 2000);
}

TEST(EpipolarPrior, RefusesWhatLiesOffItsLine) {
  const EpipolarPrior prior(kLeft, kRight, Verged());
  std::mt19937 random(2);
  for (int i = 0; i < 2000; ++i) {
    const auto match = RandomMatch(Verged().X_ClCr, random);
    if (!match) continue;
    EXPECT_FALSE(prior.Allows(match->x, match->y, match->dx, match->dy + 4));
    EXPECT_FALSE(prior.Allows(match->x, match->y, match->dx, match->dy - 4));
  }
}

TEST(EpipolarPrior, IsAsWideAsItsUncertainty) {
  // 0.5 deg are 2.5 px at this focal length, and three deviations count as possible.
  const EpipolarPrior sure(kLeft, kRight, Verged()), unsure(kLeft, kRight, Verged(0.5 * kDeg));
  RelativePose off = Verged();
  off.X_ClCr.linear() = Eigen::AngleAxisd(0.8 * kDeg, Eigen::Vector3d::UnitX()).toRotationMatrix() *
                        off.X_ClCr.linear();
  std::mt19937 random(3);
  int refused = 0, seen = 0;
  for (int i = 0; i < 2000; ++i) {
    const auto match = RandomMatch(off.X_ClCr, random);
    if (!match) continue;
    ++seen;
    EXPECT_TRUE(unsure.Allows(match->x, match->y, match->dx, match->dy));
    if (!sure.Allows(match->x, match->y, match->dx, match->dy)) ++refused;
  }
  EXPECT_GT(refused, 0.9 * seen);
  EXPECT_LT(unsure.bounds().low_y, sure.bounds().low_y - 5);
}

TEST(EpipolarPrior, RefusesACovarianceThatIsNone) {
  RelativePose pose = Verged();
  pose.covariance(0, 0) = -1;
  EXPECT_THROW(EpipolarPrior(kLeft, kRight, pose), std::invalid_argument);
  EXPECT_THROW(EpipolarPrior(kLeft, kRight, Verged(), {.min_depth_m = 0}), hardware::ConfigError);
}

/// A wall at 1 m before two parallel eyes 0.1 m apart: a disparity of -28 px everywhere.
const CameraModel kCamera({192, 144, 280, 280, 95.5, 71.5});
RelativePose Parallel(double tilt_rad = 0) {
  RelativePose pose;
  pose.X_ClCr.translation().x() = 0.1;
  pose.X_ClCr.linear() = Eigen::AngleAxisd(tilt_rad, Eigen::Vector3d::UnitX()).toRotationMatrix();
  pose.covariance.diagonal().setConstant(1e-6);
  return pose;
}

TEST(EpipolarPrior, ATrueOneChangesNoGoodMatch) {
  const testing::SyntheticPair pair = testing::ShiftedPair({192, 144}, -28, 0);
  V1ClosedFormEstimator estimator(V1Config::Preset("fast").closed_form);
  const int without = cv::countNonZero(estimator.Estimate(pair.left, pair.right).valid);
  estimator.SetPrior(EpipolarPrior(kCamera, kCamera, Parallel()));
  const int with = cv::countNonZero(estimator.Estimate(pair.left, pair.right).valid);
  EXPECT_FALSE(estimator.prior_contradicted());
  EXPECT_GE(with, 0.98 * without);
}

TEST(EpipolarPrior, AWrongOneIsNotTrusted) {
  const testing::SyntheticPair pair = testing::ShiftedPair({192, 144}, -28, 0);
  V1ClosedFormEstimator estimator(V1Config::Preset("fast").closed_form);
  const DisparityField without = estimator.Estimate(pair.left, pair.right);
  estimator.SetPrior(EpipolarPrior(kCamera, kCamera, Parallel(3 * kDeg)));
  const DisparityField with = estimator.Estimate(pair.left, pair.right);
  EXPECT_TRUE(estimator.prior_contradicted());
  EXPECT_EQ(cv::countNonZero(with.valid != without.valid), 0);
}

/// The truth lies outside of what is searched: almost nothing matches, and little contradicts.
TEST(EpipolarPrior, OneThatRulesOutTheTruthIsNotTrusted) {
  const testing::SyntheticPair pair = testing::ShiftedPair({192, 144}, -28, 0);
  V1ClosedFormEstimator estimator(V1Config::Preset("fast").closed_form);
  const DisparityField without = estimator.Estimate(pair.left, pair.right);
  RelativePose pose = Parallel();
  pose.X_ClCr.linear() = Eigen::AngleAxisd(20 * kDeg, Eigen::Vector3d::UnitY()).toRotationMatrix();
  estimator.SetPrior(EpipolarPrior(kCamera, kCamera, pose));
  const DisparityField with = estimator.Estimate(pair.left, pair.right);
  EXPECT_TRUE(estimator.prior_contradicted());
  EXPECT_EQ(cv::countNonZero(with.valid != without.valid), 0);
}

TEST(EpipolarPrior, OfAnotherImageSizeIsRefused) {
  const testing::SyntheticPair pair = testing::ShiftedPair({200, 150}, -28, 0);
  V1ClosedFormEstimator estimator(V1Config::Preset("fast").closed_form);
  estimator.SetPrior(EpipolarPrior(kCamera, kCamera, Parallel()));
  EXPECT_THROW(estimator.Estimate(pair.left, pair.right), std::invalid_argument);
}

}  // namespace
}  // namespace horopter::vision
