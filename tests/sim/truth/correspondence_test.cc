// SPDX-License-Identifier: Apache-2.0
#include "sim/truth/correspondence.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <opencv2/core.hpp>
#include <string>
#include <utility>
#include <vector>

#include "tests/sim/truth/truth_scene.h"

namespace horopter::sim {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using hardware::CameraModel;
using hardware::Pose;

/// Homography that the plane n . p_W = offset induces between two pinholes, in rays (Hartley and
/// Zisserman 2004, eq. 13.2).
Eigen::Matrix3d RayHomography(const EyeView& left, const EyeView& right, const Vector3d& n_W,
                              double offset) {
  const Pose X_RL = right.X_WC.inverse() * left.X_WC;
  const Vector3d n_L = left.X_WC.linear().transpose() * n_W;
  const double distance = offset - n_W.dot(left.X_WC.translation());
  return X_RL.linear() + X_RL.translation() * n_L.transpose() / distance;
}

void ExpectFollowsHomography(const EyeView& left, const EyeView& right) {
  const Vector3d n = Vector3d(1, 0.4, -0.3).normalized();
  TruthScene scene(R"(<mujoco><worldbody><geom type="plane" size="0 0 .1"
                      pos="1.1 0 0" zaxis="-1 -.4 .3"/></worldbody></mujoco>)");
  const double offset = n.dot(Vector3d(1.1, 0, 0));
  const SceneSnapshot now = scene.Now();
  const auto field = TrueDisparity(now, CaptureEyeTruth(now, left), right);
  const Eigen::Matrix3d H = RayHomography(left, right, n, offset);
  int visible = 0;
  for (int y = 0; y < field.dx.rows; ++y) {
    for (int x = 0; x < field.dx.cols; ++x) {
      const auto there = right.camera.Project(H * *left.camera.Unproject(Vector2d(x, y)));
      ASSERT_TRUE(there.has_value());
      ASSERT_NEAR(field.dx(y, x), there->x() - x, 1e-3);
      ASSERT_NEAR(field.dy(y, x), there->y() - y, 1e-3);
      const bool inside = right.camera.Contains(*there);
      ASSERT_EQ(field.at(y, x), inside ? Visibility::kVisible : Visibility::kOutOfView)
          << "pixel " << x << ", " << y;
      visible += inside;
    }
  }
  EXPECT_GT(visible, 500);
}

TEST(TrueDisparity, FollowsThePlaneHomographyOfAVergedRolledPair) {
  const auto camera = CameraModel::FromHorizontalFov(160, 120, 50 * kDegree);
  ExpectFollowsHomography(VergedLeft(camera), VergedRight(camera));
}

TEST(TrueDisparity, FollowsThePlaneHomographyOfMixedFieldsOfView) {
  const auto wide = CameraModel::FromHorizontalFov(160, 120, 60 * kDegree);
  const auto narrow = CameraModel::FromHorizontalFov(200, 150, 14 * kDegree);
  ExpectFollowsHomography(VergedLeft(wide), VergedRight(narrow));
  ExpectFollowsHomography(VergedLeft(narrow), VergedRight(wide));
}

TEST(TrueDisparity, FollowsThePlaneHomographyThroughLensDistortion) {
  const CameraModel other({160, 120, 180, 181, 78, 61}, {.k1 = -0.15, .p2 = -2e-3});
  ExpectFollowsHomography(VergedLeft(DistortedCamera()), VergedRight(other));
}

TEST(TrueDisparity, NearerPointsOfAParallelRigHaveNegativeDx) {
  TruthScene scene(R"(<mujoco><worldbody>
      <geom type="box" pos="2.5 0 0" size=".5 9 9"/></worldbody></mujoco>)");
  const auto camera = CameraModel::FromHorizontalFov(160, 120, 50 * kDegree);
  const EyeView left{EyePose({0, 0.05, 0}, 0, 0, 0), camera};
  const EyeView right{EyePose({0, -0.05, 0}, 0, 0, 0), camera};
  const SceneSnapshot now = scene.Now();
  const auto field = TrueDisparity(now, CaptureEyeTruth(now, left), right);
  EXPECT_NEAR(field.dx(60, 80), -camera.intrinsics().fx * 0.1 / 2.0, 1e-5);
  EXPECT_NEAR(field.dy(60, 80), 0, 1e-5);
  const auto back = TrueDisparity(now, CaptureEyeTruth(now, right), left);
  EXPECT_NEAR(back.dx(60, 80), camera.intrinsics().fx * 0.1 / 2.0, 1e-5);
}

TEST(TrueDisparity, HasNoValueWhereNothingIsSeenOrThePointIsBehindTheOtherEye) {
  TruthScene scene(R"(<mujoco><worldbody>
      <geom type="box" pos="2 0 0" size=".1 .3 .3"/></worldbody></mujoco>)");
  const auto camera = CameraModel::FromHorizontalFov(16, 12, 50 * kDegree);
  const SceneSnapshot now = scene.Now();
  const EyeView left{EyePose({0, 0, 0}, 0, 0, 0), camera};
  const EyeView turned{EyePose({0, 0, 0}, M_PI, 0, 0), camera};
  const auto field = TrueDisparity(now, CaptureEyeTruth(now, left), turned);
  EXPECT_EQ(field.at(0, 0), Visibility::kNoSurface);
  EXPECT_TRUE(std::isnan(field.dx(0, 0)));
  EXPECT_EQ(field.at(6, 8), Visibility::kOutOfView);
  EXPECT_TRUE(std::isnan(field.dx(6, 8)));
  EXPECT_GT(cv::countNonZero(field.Mask(Visibility::kNoSurface)), 50);
  EXPECT_EQ(cv::countNonZero(field.Mask(Visibility::kVisible)), 0);
}

TEST(TrueDisparity, TheFarSideOfAThingIsOccludedFromBehindIt) {
  TruthScene scene(R"(<mujoco><worldbody>
      <geom type="box" pos="2 0 0" size=".1 .3 .3"/></worldbody></mujoco>)");
  const auto camera = CameraModel::FromHorizontalFov(32, 24, 10 * kDegree);
  const SceneSnapshot now = scene.Now();
  const EyeView front{EyePose({0, 0, 0}, 0, 0, 0), camera};
  const EyeView behind{EyePose({4, 0, 0}, M_PI, 0, 0), camera};
  const auto field = TrueDisparity(now, CaptureEyeTruth(now, front), behind);
  EXPECT_GT(cv::countNonZero(field.Mask(Visibility::kOccluded)), 500);
  EXPECT_EQ(cv::countNonZero(field.Mask(Visibility::kVisible)), 0);
}

TEST(TrueDisparity, WhatIsTooNearForTheOtherEyeIsOutOfItsView) {
  TruthScene scene(R"(<mujoco><worldbody>
      <geom type="box" pos="1 0 0" size=".01 .3 .3"/></worldbody></mujoco>)");
  const auto camera = CameraModel::FromHorizontalFov(16, 12, 10 * kDegree);
  const SceneSnapshot now = scene.Now();
  const EyeView left{EyePose({0, 0, 0}, 0, 0, 0), camera};
  const EyeView close{EyePose({0.97, 0, 0}, 0, 0, 0), camera};
  const auto field = TrueDisparity(now, CaptureEyeTruth(now, left), close);
  EXPECT_EQ(field.at(6, 8), Visibility::kOutOfView);
}

/// The camera pairs that every property is held against.
struct Pair {
  const char* name;
  EyeView left, right;
};

std::vector<Pair> Pairs() {
  const auto camera = CameraModel::FromHorizontalFov(160, 120, 60 * kDegree);
  const auto narrow = CameraModel::FromHorizontalFov(160, 120, 14 * kDegree);
  const CameraModel other({150, 110, 160, 163, 70, 60}, {.k1 = 0.1, .k2 = -0.03, .p2 = 1e-3});
  return {{"verged, tilted and rolled", VergedLeft(camera), VergedRight(camera)},
          {"60 and 14 degrees", VergedLeft(camera), VergedRight(narrow)},
          {"14 and 60 degrees", VergedLeft(narrow), VergedRight(camera)},
          {"distorted", VergedLeft(DistortedCamera()), VergedRight(other)},
          {"rolled by 40 degrees",
           {EyePose({0, 0.06, 1}, -3 * kDegree, 0, 40 * kDegree), camera},
           {EyePose({0, -0.06, 1}, 3 * kDegree, 0, 0), DistortedCamera()}}};
}

TEST(TrueDisparity, AgreesWithAnalyticReprojectionOnFlatSurfaces) {
  TruthScene scene(kBoxes);
  const SceneSnapshot now = scene.Now();
  for (const Pair& pair : Pairs()) {
    const auto field = TrueDisparity(now, CaptureEyeTruth(now, pair.left), pair.right);
    double worst_px = 0;
    int compared = 0;
    for (int y = 0; y < field.dx.rows; ++y) {
      for (int x = 0; x < field.dx.cols; ++x) {
        const Ray ray = PixelRay(pair.left, x, y);
        const double depth = CastAnalytic(scene.world(), ray).depth;
        const Vector3d p_W = ray.origin + depth * ray.direction;
        const auto there = pair.right.camera.Project(pair.right.X_WC.inverse() * p_W);
        if (depth < 0 || !there) continue;
        const Vector2d error = Vector2d(field.dx(y, x) + x, field.dy(y, x) + y) - *there;
        worst_px = std::max(worst_px, error.norm());
        ++compared;
      }
    }
    EXPECT_GT(compared, 15000) << pair.name;
    EXPECT_LT(worst_px, 0.01) << pair.name;
    RecordProperty(std::string("worst px, ") + pair.name, std::to_string(worst_px));
  }
}

TEST(TrueDisparity, MasksAreTheVisibilityOfAnalyticRays) {
  TruthScene scene(kBoxes);
  const SceneSnapshot now = scene.Now();
  int all_occluded = 0;
  for (const Pair& pair : Pairs()) {
    for (const auto& [from, to] : {std::pair{pair.left, pair.right}, {pair.right, pair.left}}) {
      const auto field = TrueDisparity(now, CaptureEyeTruth(now, from), to);
      int visible = 0, occluded = 0, wrong = 0;
      for (int y = 0; y < field.dx.rows; ++y) {
        for (int x = 0; x < field.dx.cols; ++x) {
          const Visibility seen = field.at(y, x);
          if (seen != Visibility::kVisible && seen != Visibility::kOccluded) continue;
          const Ray ray = PixelRay(from, x, y);
          const Vector3d p_W = ray.origin + CastAnalytic(scene.world(), ray).depth * ray.direction;
          const Ray back(to.X_WC.translation(), p_W - to.X_WC.translation());
          const double t = CastAnalytic(scene.world(), back).depth;
          const bool reached = t < 0 || t > 1 - 1e-6;
          ++(seen == Visibility::kVisible ? visible : occluded);
          wrong += reached != (seen == Visibility::kVisible);
        }
      }
      EXPECT_GT(visible, 200) << pair.name;
      EXPECT_EQ(wrong, 0) << pair.name;
      all_occluded += occluded;
    }
  }
  EXPECT_GT(all_occluded, 1000);
}

/// The displacement there and back again, both from truth: at a visible pixel's target, the other
/// eye's own truth at that very place must lead back. The target lies between pixels, so the other
/// eye is made to look there with a pixel centre.
TEST(TrueDisparity, LeadsThereAndBack) {
  TruthScene scene(kBoxes);
  const SceneSnapshot now = scene.Now();
  for (const Pair& pair : Pairs()) {
    const auto field = TrueDisparity(now, CaptureEyeTruth(now, pair.left), pair.right);
    double worst_px = 0;
    int compared = 0;
    for (int y = 0; y < field.dx.rows; y += 4) {
      for (int x = 0; x < field.dx.cols; x += 4) {
        if (field.at(y, x) != Visibility::kVisible) continue;
        // The right camera, cropped to the one pixel whose centre is the target.
        hardware::Intrinsics in = pair.right.camera.intrinsics();
        in.cx -= x + double{field.dx(y, x)};
        in.cy -= y + double{field.dy(y, x)};
        in.width = in.height = 1;
        EyeView spot = pair.right;
        spot.camera = CameraModel(in, pair.right.camera.distortion());
        const auto back = TrueDisparity(now, CaptureEyeTruth(now, spot), pair.left);
        // A hair from an edge single precision may tip it to the surface beside.
        if (back.at(0, 0) != Visibility::kVisible) continue;
        worst_px = std::max<double>(worst_px, std::hypot(back.dx(0, 0) - x, back.dy(0, 0) - y));
        ++compared;
      }
    }
    EXPECT_GT(compared, 10) << pair.name;
    EXPECT_LT(worst_px, 0.01) << pair.name;
  }
}

TEST(TrueDisparity, FromRightToLeftIsThatFromLeftToRightTurnedRound) {
  TruthScene scene(kRound);
  const SceneSnapshot now = scene.Now();
  const Pair pair = Pairs().front();
  const EyeTruth right = CaptureEyeTruth(now, pair.right);
  const auto there = TrueDisparity(now, CaptureEyeTruth(now, pair.left), pair.right);
  const auto back = TrueDisparity(now, right, pair.left);
  int consistent = 0, visible = 0;
  for (int y = 0; y < 120; ++y) {
    for (int x = 0; x < 160; ++x) {
      if (there.at(y, x) != Visibility::kVisible) continue;
      ++visible;
      const int u = static_cast<int>(std::lround(x + there.dx(y, x)));
      const int v = static_cast<int>(std::lround(y + there.dy(y, x)));
      // Half a pixel off, so as far as the disparity differs there.
      consistent += std::hypot(there.dx(y, x) + back.dx(v, u), there.dy(y, x) + back.dy(v, u)) < 1;
    }
  }
  EXPECT_GT(visible, 5000);
  EXPECT_GT(consistent, 0.98 * visible);
}

}  // namespace
}  // namespace horopter::sim
