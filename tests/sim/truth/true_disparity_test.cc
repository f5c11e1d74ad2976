// SPDX-License-Identifier: Apache-2.0
#include "sim/truth/true_disparity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <opencv2/core.hpp>
#include <random>

namespace horopter::sim {
namespace {

using hardware::CameraModel;
using hardware::Pose;

constexpr double kDegree = M_PI / 180;

/// An eye of a head that looks along x: pan left, tilt down, then roll about the optical axis.
Pose EyePose(const Eigen::Vector3d& p_WC, double pan, double tilt, double roll) {
  Pose X = Pose::Identity();
  X.translation() = p_WC;
  X.linear() = (Eigen::AngleAxisd(pan, Eigen::Vector3d::UnitZ()) *
                Eigen::AngleAxisd(tilt, Eigen::Vector3d::UnitY()) *
                Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX()))
                   .toRotationMatrix() *
               hardware::OpticalToBody();
  return X;
}

EyeView VergedLeft(const CameraModel& camera) {
  return {EyePose({0, 0.06, 1}, -4 * kDegree, 3 * kDegree, 2 * kDegree), camera};
}

EyeView VergedRight(const CameraModel& camera) {
  return {EyePose({0.01, -0.06, 1.005}, 5 * kDegree, 1 * kDegree, -3 * kDegree), camera};
}

/// The plane n . p_W = offset as an eye would see it, exactly.
EyeTruth SeePlane(const EyeView& view, const Eigen::Vector3d& n, double offset) {
  const int rows = view.camera.height(), cols = view.camera.width();
  EyeTruth eye{view, cv::Mat1f(rows, cols), cv::Mat1i(rows, cols, 7)};
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < cols; ++x) {
      const Eigen::Vector3d ray =
          view.X_WC.linear() * *view.camera.Unproject(Eigen::Vector2d(x, y));
      eye.depth(y, x) = static_cast<float>((offset - n.dot(view.X_WC.translation())) / n.dot(ray));
    }
  }
  return eye;
}

/// Homography that a plane induces between two pinholes (Hartley and Zisserman 2004, eq. 13.2).
Eigen::Matrix3d PlaneHomography(const EyeView& left, const EyeView& right,
                                const Eigen::Vector3d& n_W, double offset) {
  const auto matrix = [](const CameraModel& camera) {
    const hardware::Intrinsics& in = camera.intrinsics();
    Eigen::Matrix3d K;
    K << in.fx, 0, in.cx, 0, in.fy, in.cy, 0, 0, 1;
    return K;
  };
  const Pose X_RL = right.X_WC.inverse() * left.X_WC;
  const Eigen::Vector3d n_L = left.X_WC.linear().transpose() * n_W;
  const double distance = offset - n_W.dot(left.X_WC.translation());
  return matrix(right.camera) * (X_RL.linear() + X_RL.translation() * n_L.transpose() / distance) *
         matrix(left.camera).inverse();
}

void ExpectFollowsHomography(const EyeView& left, const EyeView& right) {
  const Eigen::Vector3d n = Eigen::Vector3d(1, 0.4, -0.3).normalized();
  constexpr double kOffset = 1.1;
  const auto field = TrueDisparity(SeePlane(left, n, kOffset), SeePlane(right, n, kOffset));
  const Eigen::Matrix3d H = PlaneHomography(left, right, n, kOffset);
  int visible = 0;
  for (int y = 0; y < field.dx.rows; ++y) {
    for (int x = 0; x < field.dx.cols; ++x) {
      const Eigen::Vector2d there = (H * Eigen::Vector3d(x, y, 1)).hnormalized();
      ASSERT_NEAR(field.dx(y, x), there.x() - x, 1e-3);
      ASSERT_NEAR(field.dy(y, x), there.y() - y, 1e-3);
      const bool inside = right.camera.Contains(there);
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

TEST(TrueDisparity, ProjectsThroughLensDistortion) {
  const CameraModel left({160, 120, 170, 165, 81, 58}, {.k1 = -0.2, .k2 = 0.05, .p1 = 1e-3});
  const CameraModel right({160, 120, 180, 181, 78, 61}, {.k1 = -0.15, .p2 = -2e-3});
  const EyeView left_view = VergedLeft(left), right_view = VergedRight(right);
  const Eigen::Vector3d n = Eigen::Vector3d::UnitX();
  const auto field = TrueDisparity(SeePlane(left_view, n, 1.5), SeePlane(right_view, n, 1.5));
  const Eigen::Matrix3d H =
      PlaneHomography({left_view.X_WC, CameraModel({1, 1, 1, 1, 0, 0})},
                      {right_view.X_WC, CameraModel({1, 1, 1, 1, 0, 0})}, n, 1.5);
  int visible = 0;
  for (int y = 0; y < 120; y += 7) {
    for (int x = 0; x < 160; x += 7) {
      const auto there = right.Project(H * *left.Unproject(Eigen::Vector2d(x, y)));
      ASSERT_TRUE(there.has_value());
      EXPECT_NEAR(field.dx(y, x), there->x() - x, 1e-3);
      EXPECT_NEAR(field.dy(y, x), there->y() - y, 1e-3);
      if (!right.Contains(*there)) continue;
      ++visible;
      EXPECT_EQ(field.at(y, x), Visibility::kVisible);
    }
  }
  EXPECT_GT(visible, 200);
}

TEST(TrueDisparity, NearerPointsOfAParallelRigHaveNegativeDx) {
  const auto camera = CameraModel::FromHorizontalFov(160, 120, 50 * kDegree);
  const EyeView left{EyePose({0, 0.05, 0}, 0, 0, 0), camera};
  const EyeView right{EyePose({0, -0.05, 0}, 0, 0, 0), camera};
  const Eigen::Vector3d n = Eigen::Vector3d::UnitX();
  const auto field = TrueDisparity(SeePlane(left, n, 2.0), SeePlane(right, n, 2.0));
  EXPECT_NEAR(field.dx(60, 80), -camera.intrinsics().fx * 0.1 / 2.0, 1e-4);
  EXPECT_NEAR(field.dy(60, 80), 0, 1e-4);
}

TEST(TrueDisparity, HasNoValueWhereNothingIsSeenOrThePointIsBehindTheOtherEye) {
  const auto camera = CameraModel::FromHorizontalFov(16, 12, 50 * kDegree);
  const EyeView left{EyePose({0, 0, 0}, 0, 0, 0), camera};
  const EyeView turned{EyePose({0, 0, 0}, M_PI, 0, 0), camera};
  EyeTruth seen = SeePlane(left, Eigen::Vector3d::UnitX(), 2.0);
  seen.depth(3, 4) = std::numeric_limits<float>::infinity();
  seen.ids(3, 4) = -1;
  const auto field = TrueDisparity(seen, SeePlane(turned, -Eigen::Vector3d::UnitX(), 2.0));
  EXPECT_EQ(field.at(3, 4), Visibility::kNoSurface);
  EXPECT_TRUE(std::isnan(field.dx(3, 4)));
  EXPECT_EQ(field.at(5, 5), Visibility::kOutOfView);
  EXPECT_TRUE(std::isnan(field.dx(5, 5)));
  EXPECT_EQ(cv::countNonZero(field.Mask(Visibility::kNoSurface)), 1);
}

// A plane with boxes in front of it, on it and beside each other, in a room.
constexpr const char* kBoxes = R"(
<mujoco>
  <worldbody>
    <geom name="wall" type="box" pos="3 0 1" size=".05 4 4"/>
    <geom name="floor" type="plane" pos="0 0 0" size="5 5 .1"/>
    <geom name="near" type="box" pos="1.2 .1 1" size=".1 .15 .2" euler="0 0 25"/>
    <geom name="slanted" type="box" pos="1.7 -.4 .9" size=".05 .3 .2" euler="20 -30 40"/>
    <geom name="poster" type="box" pos="2.94 .7 1.3" size=".011 .3 .2"/>
    <geom name="pole" type="box" pos="2 .5 1" size=".02 .02 1"/>
  </worldbody>
</mujoco>)";

/// Whether the right eye sees the point: an analytic ray from there meets nothing before it.
bool RayReaches(const World& world, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  constexpr mjtByte kGroups[mjNGROUP] = {1, 1, 1, 0, 0, 0};
  const Eigen::Vector3d along = to - from;
  int geom = -1;
  const double t =
      mj_ray(&world.model(), &world.data(), from.data(), along.data(), kGroups, 1, -1, &geom);
  return t < 0 || t > 1 - 2e-4;
}

struct Agreement {
  int visible = 0;
  int occluded = 0;
  int edge = 0;
  int wrong = 0;
};

Agreement CompareWithRays(const World& world, const GroundTruth& truth) {
  const auto field = TrueDisparity(truth);
  const EyeView& left = truth.left.view;
  Agreement agreement;
  for (int y = 0; y < field.dx.rows; ++y) {
    for (int x = 0; x < field.dx.cols; ++x) {
      const Visibility visibility = field.at(y, x);
      agreement.edge += visibility == Visibility::kEdge;
      if (visibility != Visibility::kVisible && visibility != Visibility::kOccluded) continue;
      const Eigen::Vector3d p_W = left.X_WC * (*left.camera.Unproject(Eigen::Vector2d(x, y)) *
                                               double{truth.left.depth(y, x)});
      const bool reached = RayReaches(world, truth.right.view.X_WC.translation(), p_W);
      ++(visibility == Visibility::kVisible ? agreement.visible : agreement.occluded);
      agreement.wrong += reached != (visibility == Visibility::kVisible);
    }
  }
  return agreement;
}

TEST(TrueDisparity, OcclusionAgreesWithRays) {
  const auto world = World::FromXml(kBoxes);
  Renderer renderer(*world, {.width = 320, .height = 240});
  const auto camera = CameraModel::FromHorizontalFov(320, 240, 60 * kDegree);
  const auto narrow = CameraModel::FromHorizontalFov(240, 180, 30 * kDegree);
  for (const auto& [left, right] : {std::pair{VergedLeft(camera), VergedRight(camera)},
                                    {VergedRight(camera), VergedLeft(camera)},
                                    {VergedLeft(narrow), VergedRight(camera)},
                                    {VergedLeft(camera), VergedRight(narrow)}}) {
    const auto truth = CaptureGroundTruth(*world, renderer, left, right, Pose::Identity(), {});
    const Agreement agreement = CompareWithRays(*world, truth);
    const int decided = agreement.visible + agreement.occluded;
    EXPECT_GT(agreement.visible, 10000);
    EXPECT_GT(agreement.occluded, 300);
    EXPECT_LT(agreement.edge, 0.03 * decided);
    EXPECT_LT(agreement.wrong, 1e-4 * decided);
  }
}

}  // namespace
}  // namespace horopter::sim
