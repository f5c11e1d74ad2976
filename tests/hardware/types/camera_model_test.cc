// SPDX-License-Identifier: Apache-2.0
#include "hardware/types/camera_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <opencv2/calib3d.hpp>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace horopter::hardware {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Coefficients as calibrations of real cameras give them.
const std::vector<Distortion>& RealDistortions() {
  static const std::vector<Distortion> distortions = {
      {},
      {-0.2834, 0.0739, 0.00019, 0.000017, 0},                // EuRoC cam0, 79 deg
      {-0.3691481, 0.1968681, 0.0013548, 0.000567, -0.0677},  // KITTI 2011_09_26 grey, full
      {0.0391, -0.1102, 0.0015, -0.0008, 0.0605},             // a webcam: pincushion, then barrel
      {0.2624, -0.9531, -0.0054, 0.0026, 1.1633},             // Kinect RGB (TUM freiburg1)
  };
  return distortions;
}

Intrinsics Vga(double f) { return {640, 480, f, f * 1.01, 322.3, 236.8}; }

std::vector<Vector3d> PointsInFront(int count, double max_tangent, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> tangent(-max_tangent, max_tangent), depth(0.2, 8.0);
  std::vector<Vector3d> points;
  for (int i = 0; i < count; ++i) {
    const double z = depth(random);
    points.emplace_back(tangent(random) * z, tangent(random) * z, z);
  }
  return points;
}

TEST(CameraModel, UnprojectInvertsProjectForEveryFieldOfViewAndLens) {
  for (const double fov_deg : {14.0, 43.3, 60.0, 90.0}) {
    const double f = 320 / std::tan(fov_deg * M_PI / 360);
    for (const Distortion& distortion : RealDistortions()) {
      const CameraModel camera(Vga(f), distortion);
      int seen = 0;
      for (const Vector3d& p_C : PointsInFront(300, 320 / f, 7)) {
        const auto pixel = camera.Project(p_C);
        if (!pixel) continue;
        ++seen;
        const auto direction = camera.Unproject(*pixel);
        ASSERT_TRUE(direction.has_value()) << pixel->transpose();
        EXPECT_LT((*direction * p_C.z() - p_C).norm() / p_C.z(), 1e-9)
            << fov_deg << " deg, k1 = " << distortion.k1;
      }
      EXPECT_GE(seen, 200) << "the fold must lie outside most of a " << fov_deg << " deg image";
    }
  }
}

TEST(CameraModel, ProjectsAsOpenCvDoes) {
  for (const Distortion& d : RealDistortions()) {
    const CameraModel camera(Vga(420), d);
    const Intrinsics& in = camera.intrinsics();
    const cv::Matx33d K(in.fx, 0, in.cx, 0, in.fy, in.cy, 0, 0, 1);
    const std::vector<double> coefficients = {d.k1, d.k2, d.p1, d.p2, d.k3};
    for (const Vector3d& p_C : PointsInFront(200, 0.5, 11)) {
      const auto ours = camera.Project(p_C);
      ASSERT_TRUE(ours.has_value());
      std::vector<cv::Point2d> theirs;
      cv::projectPoints(std::vector<cv::Point3d>{{p_C.x(), p_C.y(), p_C.z()}}, cv::Vec3d(),
                        cv::Vec3d(), K, coefficients, theirs);
      EXPECT_NEAR(ours->x(), theirs[0].x, 1e-9);
      EXPECT_NEAR(ours->y(), theirs[0].y, 1e-9);
    }
  }
}

TEST(CameraModel, EdgesOfTheFieldOfViewAreHalfAPixelOutsideTheOuterCentres) {
  const double fov = 60 * M_PI / 180;
  const CameraModel camera = CameraModel::FromHorizontalFov(320, 240, fov);
  EXPECT_DOUBLE_EQ(camera.intrinsics().cx, 159.5);
  EXPECT_DOUBLE_EQ(camera.intrinsics().cy, 119.5);
  const auto left = camera.Project({-std::tan(fov / 2), 0, 1});
  const auto right = camera.Project({std::tan(fov / 2), 0, 1});
  ASSERT_TRUE(left && right);
  EXPECT_NEAR(left->x(), -0.5, 1e-10);
  EXPECT_NEAR(right->x(), 319.5, 1e-10);
  EXPECT_NEAR(camera.horizontal_fov_rad(), fov, 1e-12);
  EXPECT_NEAR(std::tan(camera.vertical_fov_rad() / 2), std::tan(fov / 2) * 240 / 320, 1e-12);
}

TEST(CameraModel, ContainsExactlyThePixelsOfTheImage) {
  const CameraModel camera = CameraModel::FromHorizontalFov(320, 240, 1.0);
  EXPECT_TRUE(camera.Contains({-0.5, -0.5}));
  EXPECT_TRUE(camera.Contains({319.49, 239.49}));
  EXPECT_FALSE(camera.Contains({319.5, 100}));
  EXPECT_FALSE(camera.Contains({100, 239.5}));
  EXPECT_FALSE(camera.Contains({-0.51, 100}));
  EXPECT_FALSE(camera.Contains({kNaN, 100}));
}

TEST(CameraModel, AxesAreRightDownForward) {
  const CameraModel camera = CameraModel::FromHorizontalFov(320, 240, 1.0);
  EXPECT_GT(camera.Project({0.1, 0, 1})->x(), 159.5);
  EXPECT_GT(camera.Project({0, 0.1, 1})->y(), 119.5);
}

TEST(CameraModel, NothingBehindOrUndefinedIsSeen) {
  const CameraModel camera = CameraModel::FromHorizontalFov(320, 240, 1.0);
  EXPECT_FALSE(camera.Project({0, 0, 0}));
  EXPECT_FALSE(camera.Project({0.1, 0.1, -1}));
  EXPECT_FALSE(camera.Project({kNaN, 0, 1}));
  EXPECT_FALSE(camera.Project({0, 0, std::numeric_limits<double>::infinity()}));
  EXPECT_FALSE(camera.Unproject({kNaN, 3}));
}

TEST(CameraModel, BeyondTheFoldOfTheLensThereIsNothing) {
  // r (1 + k1 r^2) grows up to r = 1 / sqrt(-3 k1), where it is 2/3 of that r.
  const double k1 = -0.3;
  const double fold = 1 / std::sqrt(-3 * k1);
  const CameraModel camera({640, 480, 400, 400, 319.5, 239.5}, {k1, 0, 0, 0, 0});
  EXPECT_TRUE(camera.Project({0.999 * fold, 0, 1}));
  EXPECT_FALSE(camera.Project({1.001 * fold, 0, 1}));
  EXPECT_FALSE(camera.Project({3 * fold, 0, 1}));
  EXPECT_TRUE(camera.Unproject({319.5 + 400 * 0.999 * fold * 2 / 3, 239.5}));
  EXPECT_FALSE(camera.Unproject({319.5 + 400 * 1.001 * fold * 2 / 3, 239.5}));
  EXPECT_FALSE(camera.Unproject({319.5 + 400 * 4 * fold, 239.5}));
}

TEST(CameraModel, FindsAFoldThatOnlyANarrowDipOfTheSlopeMakes) {
  // Slope 1 + 3 k1 s + 5 k2 s^2 with roots s = 1.000 and 1.002: growing on both sides of it.
  const double product = 1.000 * 1.002, sum = 2.002;
  const CameraModel camera({640, 480, 400, 400, 319.5, 239.5},
                           {-sum / product / 3, 1 / product / 5, 0, 0, 0});
  EXPECT_TRUE(camera.Project({0.9995, 0, 1}));
  EXPECT_FALSE(camera.Project({1.0005, 0, 1}));
  EXPECT_FALSE(camera.Project({1.2, 0, 1}));
}

TEST(CameraModel, UnprojectsOnTheNearSideWhereThePixelLiesPastTheFold) {
  // Pincushion near the centre: the distorted radius of a point just inside the fold is larger
  // than the fold's own, undistorted radius.
  const CameraModel camera({640, 480, 400, 400, 319.5, 239.5}, {0.9, -0.45, 0, 0, 0});
  double radius = 0.05;
  for (; camera.Project({radius, 0, 1}); radius += 0.01) {
    const auto direction = camera.Unproject(*camera.Project({radius, 0, 1}));
    ASSERT_TRUE(direction.has_value()) << radius;
    EXPECT_NEAR(direction->x(), radius, 1e-9);
  }
  EXPECT_GT(radius, 1.0);
  EXPECT_LT(radius, 1.6);
}

TEST(CameraModel, UndistortedKeepsIntrinsics) {
  const CameraModel camera(Vga(420), RealDistortions()[1]);
  const CameraModel plain = camera.Undistorted();
  EXPECT_FALSE(plain.distortion().any());
  EXPECT_DOUBLE_EQ(plain.intrinsics().fy, camera.intrinsics().fy);
  const auto pixel = plain.Project({0.3, -0.2, 1});
  EXPECT_NEAR(pixel->x(), 420 * 0.3 + 322.3, 1e-12);
}

std::set<std::string> BadFields(const Intrinsics& intrinsics, const Distortion& distortion) {
  try {
    const CameraModel camera(intrinsics, distortion);
  } catch (const ConfigError& error) {
    std::set<std::string> fields;
    for (const FieldError& bad : error.errors()) {
      fields.insert(bad.field);
      EXPECT_NE(std::string(error.what()).find(bad.ToString()), std::string::npos);
    }
    return fields;
  }
  return {};
}

TEST(CameraModel, InvalidInputListsEveryBadField) {
  EXPECT_EQ(BadFields({0, -3, 0, -1, kNaN, kNaN}, {kNaN, kNaN, kNaN, kNaN, kNaN}),
            (std::set<std::string>{"camera.width", "camera.height", "camera.fx", "camera.fy",
                                   "camera.cx", "camera.cy", "camera.k1", "camera.k2", "camera.p1",
                                   "camera.p2", "camera.k3"}));
  EXPECT_EQ(BadFields({640, 480, 400, 400, 319.5, 239.5}, {0, 0, kNaN, 0, 0}),
            (std::set<std::string>{"camera.p1"}));
  EXPECT_EQ(BadFields({640, 480, 400, 400, 319.5, 239.5}, {}), std::set<std::string>{});
}

TEST(CameraModel, BadFieldOfViewAndSizeAreReportedTogetherAndReadably) {
  try {
    CameraModel::FromHorizontalFov(0, 240, M_PI);
    FAIL() << "accepted a width of 0 and a field of view of 180 deg";
  } catch (const ConfigError& error) {
    ASSERT_EQ(error.errors().size(), 2u);
    EXPECT_EQ(error.errors()[0].ToString(), "camera.width = 0: must be at least 1");
    EXPECT_EQ(error.errors()[1].field, "camera.horizontal_fov_rad");
  }
  EXPECT_THROW(CameraModel::FromHorizontalFov(320, 240, kNaN), ConfigError);
}

}  // namespace
}  // namespace horopter::hardware
