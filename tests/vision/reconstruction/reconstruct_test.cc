// SPDX-License-Identifier: Apache-2.0
#include "vision/reconstruction/reconstruct.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <opencv2/core.hpp>
#include <random>

#include "tests/vision/reconstruction/verged_pair.h"

namespace horopter::vision {
namespace {

using hardware::CameraModel;
using hardware::Eye;
using hardware::HeadAngles;
using hardware::PerEye;
using hardware::Pose;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr double kBaseline = 0.08;

DisparityField NoDisparity(cv::Size size) {
  return {cv::Mat1f(size, kNan), cv::Mat1f(size, kNan), cv::Mat1f(size, 0.f), cv::Mat1b(size, 0)};
}

PerEye<CameraModel> SameCameras(const CameraModel& camera) { return {camera, camera}; }

CameraModel Camera() { return CameraModel::FromHorizontalFov(160, 120, 1.05); }

CameraModel DistortedCamera() {
  return CameraModel({160, 120, 140, 138, 83.2, 57.7}, {-0.28, 0.09, 1e-3, -7e-4, 0});
}

PointField Reconstruct(const DisparityField& disparity, const PerEye<CameraModel>& cameras,
                       const HeadAngles& angles, double baseline_m) {
  return Reconstructor(cameras).Reconstruct(disparity, angles, baseline_m);
}

PerEye<Pose> Poses(const HeadAngles& angles) {
  return {EyeInHead(angles.left, Eye::kLeft, kBaseline),
          EyeInHead(angles.right, Eye::kRight, kBaseline)};
}

HeadAngles Verged(double pan, double tilt, double vergence, double tilt_difference) {
  HeadAngles a;
  a.left = {pan - vergence / 2, tilt + tilt_difference / 2};
  a.right = {pan + vergence / 2, tilt - tilt_difference / 2};
  return a;
}

/// A scene: for a left pixel, the point of a bumpy surface there, in the head frame.
Eigen::Vector3d PointSeenAt(const CameraModel& camera, const Pose& X_HCl, int u, int v) {
  const double depth = 1.0 + 0.3 * std::sin(0.05 * u) + 0.2 * std::cos(0.07 * v);
  return X_HCl * (*camera.Unproject(Eigen::Vector2d(u, v)) * depth);
}

/// The exact disparity of that scene.
DisparityField TrueDisparity(const PerEye<CameraModel>& cameras, const HeadAngles& angles) {
  const PerEye<Pose> X_HC = Poses(angles);
  DisparityField d = NoDisparity({cameras.left.width(), cameras.left.height()});
  for (int v = 0; v < d.dx.rows; ++v) {
    for (int u = 0; u < d.dx.cols; ++u) {
      const Eigen::Vector3d p_H = PointSeenAt(cameras.left, X_HC.left, u, v);
      const auto seen = See(cameras.right, X_HC.right, p_H);
      if (!seen) continue;
      d.dx(v, u) = static_cast<float>(seen->x() - u);
      d.dy(v, u) = static_cast<float>(seen->y() - v);
      d.valid(v, u) = 255;
    }
  }
  return d;
}

/// Largest error against the scene; every valid pixel but those at the image border must have a
/// point.
double LargestError(const PointField& field, const DisparityField& d, const CameraModel& camera,
                    const Pose& X_HCl) {
  double largest = 0;
  for (int v = 0; v < d.dx.rows; ++v) {
    for (int u = 0; u < d.dx.cols; ++u) {
      const cv::Vec3f p = field.points(v, u);
      EXPECT_EQ(std::isnan(p[0]), d.valid(v, u) == 0) << u << "," << v;
      if (std::isnan(p[0])) continue;
      const Eigen::Vector3d expected = PointSeenAt(camera, X_HCl, u, v);
      largest = std::max(largest, (Eigen::Vector3d(p[0], p[1], p[2]) - expected).norm());
    }
  }
  return largest;
}

// Disparities are floats: a right coordinate of about 100 px is good to 4e-6 px, which at 1.5 m
// costs Z^2 / (f b) * 4e-6 = 8e-7 m; 1e-5 leaves room for obliquity.
TEST(Triangulation, RecoversPointFromVergedPair) {
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> pan(-0.5, 0.5), tilt(-0.4, 0.4), vergence(0.0, 0.15),
      difference(-0.08, 0.08);
  const auto cameras = SameCameras(Camera());
  const Reconstructor reconstructor(cameras);
  for (int i = 0; i < 20; ++i) {
    const HeadAngles angles =
        Verged(pan(generator), tilt(generator), vergence(generator), difference(generator));
    const DisparityField d = TrueDisparity(cameras, angles);
    ASSERT_GT(cv::countNonZero(d.valid), 5000);
    const PointField field = reconstructor.Reconstruct(d, angles, kBaseline);
    EXPECT_LT(LargestError(field, d, cameras.left, Poses(angles).left), 1e-5);
    double residual = 0;
    cv::minMaxLoc(field.residual_m, nullptr, &residual, nullptr, nullptr, d.valid);
    EXPECT_LT(residual, 1e-5);
  }
}

TEST(Triangulation, RecoversPointWithEyesTiltedOppositeWays) {
  const auto cameras = SameCameras(Camera());
  const HeadAngles angles = Verged(0.1, 0.05, 0.08, 0.3);
  const DisparityField d = TrueDisparity(cameras, angles);
  ASSERT_GT(cv::countNonZero(d.valid), 3000);
  EXPECT_LT(
      LargestError(Reconstruct(d, cameras, angles, kBaseline), d, cameras.left, Poses(angles).left),
      1e-5);
}

TEST(Triangulation, TakesOutDistortionPrincipalPointAndUnequalLenses) {
  const PerEye<CameraModel> cameras{DistortedCamera(), Camera()};
  const PerEye<CameraModel> swapped{Camera(), DistortedCamera()};
  const HeadAngles angles = Verged(-0.2, 0.1, 0.07, 0.02);
  const DisparityField d = TrueDisparity(cameras, angles);
  EXPECT_LT(
      LargestError(Reconstruct(d, cameras, angles, kBaseline), d, cameras.left, Poses(angles).left),
      1e-5);
  const DisparityField e = TrueDisparity(swapped, angles);
  EXPECT_LT(
      LargestError(Reconstruct(e, swapped, angles, kBaseline), e, swapped.left, Poses(angles).left),
      1e-5);
}

TEST(Triangulation, PosesAndAnglesAgree) {
  const auto cameras = SameCameras(Camera());
  const HeadAngles angles = Verged(0.2, -0.1, 0.1, 0.04);
  const DisparityField d = TrueDisparity(cameras, angles);
  const Reconstructor reconstructor(cameras);
  const PointField a = reconstructor.Reconstruct(d, angles, kBaseline);
  const PointField b = reconstructor.Reconstruct(d, Poses(angles));
  EXPECT_LT(cv::norm(a.points, b.points, cv::NORM_INF, d.valid), 1e-6);
}

TEST(Triangulation, OpticalCentresBeforeTheirAxesAreAccountedFor) {
  constexpr double kLever = 0.03;
  const auto cameras = SameCameras(Camera());
  const HeadAngles angles = Verged(0.2, -0.1, 0.1, 0.04);
  PerEye<Pose> poses = Poses(angles);
  for (const Eye eye : hardware::kBothEyes) {
    poses[eye].translation() += kLever * poses[eye].linear().col(2);
  }
  const DisparityField d = TrueDisparity(cameras, angles);
  const Reconstructor reconstructor(cameras);
  const PointField a = reconstructor.Reconstruct(d, angles, kBaseline, kLever);
  const PointField b = reconstructor.Reconstruct(d, poses);
  EXPECT_LT(cv::norm(a.points, b.points, cv::NORM_INF, d.valid), 1e-6);
  EXPECT_GT(cv::norm(a.points, reconstructor.Reconstruct(d, angles, kBaseline).points, cv::NORM_INF,
                     d.valid),
            kLever / 2);
}

TEST(Triangulation, DepthNoiseIsWhatTheGeometryPredicts) {
  const CameraModel camera = CameraModel::FromHorizontalFov(160, 120, 1.0);
  const double f = camera.intrinsics().fx;
  std::mt19937 generator(11);
  std::normal_distribution<double> noise(0, 0.05);
  for (const double Z : {0.5, 1.0, 1.5}) {
    DisparityField d = NoDisparity({160, 120});
    d.valid(cv::Rect(40, 20, 100, 80)) = 255;
    for (int v = 20; v < 100; ++v) {
      for (int u = 40; u < 140; ++u) {
        d.dx(v, u) = static_cast<float>(-f * kBaseline / Z + noise(generator));
        d.dy(v, u) = static_cast<float>(noise(generator));
      }
    }
    const PointField field = Reconstruct(d, SameCameras(camera), {}, kBaseline);
    cv::Mat1f forward;
    cv::extractChannel(field.points, forward, 0);
    cv::Scalar mean, deviation;
    cv::meanStdDev(forward, mean, deviation, d.valid);
    const double predicted = Z * Z * 0.05 / (f * kBaseline);
    EXPECT_NEAR(mean[0], Z, predicted);
    EXPECT_NEAR(deviation[0] / predicted, 1, 0.15) << "at " << Z << " m";
  }
}

TEST(Triangulation, VerticalMismatchShowsInTheResidual) {
  const auto cameras = SameCameras(Camera());
  const HeadAngles angles = Verged(0, 0, 0.08, 0);
  DisparityField d = TrueDisparity(cameras, angles);
  d.dy += 4;
  const PointField field = Reconstruct(d, cameras, angles, kBaseline);
  // The rays pass each other by 4 px of the depth there; the point lies midway.
  const double expected = field.points(60, 80)[0] * 4 / cameras.left.intrinsics().fy / 2;
  EXPECT_NEAR(field.residual_m(60, 80), expected, 0.05 * expected);
}

TEST(Triangulation, GivesNoPointWhereThereIsNone) {
  const auto cameras = SameCameras(Camera());
  DisparityField d = NoDisparity({160, 120});
  const auto put = [&d](int v, float dx, float dy, bool valid) {
    d.dx(v, 80) = dx;
    d.dy(v, 80) = dy;
    d.valid(v, 80) = valid ? 255 : 0;
  };
  put(10, -10, 0, true);   // a good one
  put(20, -10, 0, false);  // marked invalid
  put(30, 0, 0, true);     // parallel rays
  put(40, 10, 0, true);    // rays that meet behind the eyes
  put(50, -81, 0, true);   // outside the right image
  put(60, kNan, 0, true);  // contradictory input
  put(70, -10, 80, true);  // below the right image
  const PointField field = Reconstruct(d, cameras, {}, kBaseline);
  for (int v = 0; v < 120; ++v) {
    EXPECT_EQ(std::isnan(field.points(v, 80)[0]), v != 10) << "row " << v;
    EXPECT_EQ(std::isnan(field.residual_m(v, 80)), v != 10) << "row " << v;
  }
}

TEST(Triangulation, SameBitsForAnyNumberOfThreads) {
  const auto cameras = SameCameras(DistortedCamera());
  const HeadAngles angles = Verged(0.1, 0.1, 0.08, 0.02);
  const DisparityField d = TrueDisparity(cameras, angles);
  const int before = cv::getNumThreads();
  cv::setNumThreads(1);
  const PointField one = Reconstruct(d, cameras, angles, kBaseline);
  cv::setNumThreads(4);
  const PointField four = Reconstruct(d, cameras, angles, kBaseline);
  cv::setNumThreads(before);
  ASSERT_TRUE(one.points.isContinuous() && four.points.isContinuous());
  EXPECT_EQ(std::memcmp(one.points.data, four.points.data, one.points.total() * 12), 0);
  EXPECT_EQ(std::memcmp(one.residual_m.data, four.residual_m.data, one.residual_m.total() * 4), 0);
}

TEST(Triangulation, RefusesBadInput) {
  const auto cameras = SameCameras(Camera());
  const DisparityField d = NoDisparity({160, 120});
  EXPECT_THROW((void)Reconstruct(NoDisparity({80, 60}), cameras, {}, 0.1), std::invalid_argument);
  EXPECT_THROW((void)Reconstruct(d, cameras, {}, 0), std::invalid_argument);
  HeadAngles bad;
  bad.right.tilt_rad = kNan;
  EXPECT_THROW((void)Reconstruct(d, cameras, bad, 0.1), std::invalid_argument);
  ReconstructionConfig config;
  config.min_parallax_rad = 0;
  EXPECT_THROW(Reconstructor(cameras, config), hardware::ConfigError);
}

}  // namespace
}  // namespace horopter::vision
