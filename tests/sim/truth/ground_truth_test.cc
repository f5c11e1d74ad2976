// SPDX-License-Identifier: Apache-2.0
#include "sim/truth/ground_truth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>

#include "tests/sim/truth/truth_scene.h"

namespace horopter::sim {
namespace {

using Eigen::Vector3d;
using hardware::CameraModel;
using hardware::Pose;

TEST(GroundTruth, ShowsTheWorldOfNow) {
  TruthScene scene(R"(
      <mujoco>
        <worldbody>
          <geom name="floor" type="plane" size="5 5 .1"/>
          <body name="crate" pos="2 0 .0999"><freejoint/>
            <geom name="crate_box" type="box" size=".1 1 .1"/></body>
        </worldbody>
      </mujoco>)");
  for (int i = 0; i < 20; ++i) scene.world().Step();
  const EyeView left{EyePose({0, 0.03, 0.1}, 0, 0, 0), CameraModel::FromHorizontalFov(64, 48, 1.0)};
  const EyeView right{EyePose({0.5, -0.03, 0.1}, 0, 0, 0),
                      CameraModel::FromHorizontalFov(33, 21, 0.4)};

  const GroundTruth truth = CaptureGroundTruth(scene.world(), scene.shapes(), left, right);

  EXPECT_EQ(truth.state.t, scene.world().now());
  EXPECT_EQ(truth.state.contacts.size(), 4u);
  EXPECT_EQ(truth.left.depth.size(), cv::Size(64, 48));
  EXPECT_EQ(truth.right.depth.size(), cv::Size(33, 21));
  EXPECT_NEAR(truth.left.depth(24, 32), 1.9, 1e-3);
  EXPECT_NEAR(truth.right.depth(10, 16), 1.4, 1e-3);
  EXPECT_EQ(truth[hardware::Eye::kRight].ids(10, 16), scene.Geom("crate_box"));
  EXPECT_EQ(truth.left.ids(47, 32), scene.Geom("floor"));
  EXPECT_TRUE(truth.right.view.X_WC.isApprox(right.X_WC));
  EXPECT_EQ(truth.left.ids(0, 0), -1);
  EXPECT_TRUE(std::isinf(truth.left.depth(0, 0)));
  EXPECT_TRUE(std::isnan(truth.left.normals(0, 0)[0]));
}

TEST(EyeTruth, OfADistortedCameraIsThatOfItsOwnRays) {
  TruthScene scene(kBoxes);
  const EyeView view = VergedLeft(DistortedCamera());
  const EyeTruth truth = CaptureEyeTruth(scene.Now(), view);
  for (int y = 0; y < 120; ++y) {
    for (int x = 0; x < 160; ++x) {
      const auto [depth, geom] = CastAnalytic(scene.world(), PixelRay(view, x, y));
      ASSERT_EQ(truth.ids(y, x), geom);
      ASSERT_NEAR(truth.depth(y, x), depth, 1e-7 * depth);  // what single precision leaves
    }
  }
}

TEST(EyeTruth, NormalsAreTheSurfacesOwnInTheEyesFrame) {
  TruthScene flat(kBoxes), round(kRound);
  const EyeView view = VergedLeft(DistortedCamera());
  const EyeTruth boxes = CaptureEyeTruth(flat.Now(), view);
  const EyeTruth balls = CaptureEyeTruth(round.Now(), view);
  int on_ball = 0;
  for (int y = 0; y < 120; ++y) {
    for (int x = 0; x < 160; ++x) {
      const auto normal = [&](const EyeTruth& truth) {
        const cv::Vec3f n = truth.normals(y, x);
        return Vector3d(view.X_WC.linear() * Vector3d(n[0], n[1], n[2]));
      };
      ASSERT_NEAR(normal(boxes).norm(), 1, 1e-6);
      if (boxes.ids(y, x) == flat.Geom("wall")) {
        ASSERT_LT((normal(boxes) + Vector3d::UnitX()).norm(), 1e-6);
      }
      if (boxes.ids(y, x) == flat.Geom("floor")) {
        ASSERT_LT((normal(boxes) - Vector3d::UnitZ()).norm(), 1e-6);
      }
      if (balls.ids(y, x) != round.Geom("ball")) continue;
      ++on_ball;
      const Ray ray = PixelRay(view, x, y);
      const Vector3d p = ray.origin + balls.depth(y, x) * ray.direction;
      ASSERT_LT((normal(balls) - (p - Vector3d(1.2, .35, 1.2)).normalized()).norm(), 1e-5);
    }
  }
  EXPECT_GT(on_ball, 100);
}

TEST(EyeTruth, NothingIsSeenNearerThanNearOrBeyondFar) {
  TruthScene scene(R"(
      <mujoco><worldbody>
        <geom name="lens" type="box" pos=".02 0 0" size=".005 .1 .1"/>
        <geom name="wall" type="box" pos="3.1 0 0" size=".1 4 4"/>
      </worldbody></mujoco>)");
  EyeView view{EyePose({0, 0, 0}, 0, 0, 0), CameraModel::FromHorizontalFov(9, 7, 0.5)};
  EXPECT_NEAR(CaptureEyeTruth(scene.Now(), view).depth(3, 4), 3, 1e-6);
  view.near_m = 0.001;
  EXPECT_NEAR(CaptureEyeTruth(scene.Now(), view).depth(3, 4), 0.015, 1e-8);
  view.near_m = 0.03;
  view.far_m = 2;
  EXPECT_EQ(CaptureEyeTruth(scene.Now(), view).ids(3, 4), -1);
}

TEST(EyeTruth, IsTheSameOnAnyNumberOfThreads) {
  TruthScene scene(kRound);
  const EyeView view = VergedRight(DistortedCamera());
  const int threads = cv::getNumThreads();
  const EyeTruth many = CaptureEyeTruth(scene.Now(), view);
  cv::setNumThreads(1);
  const EyeTruth one = CaptureEyeTruth(scene.Now(), view);
  cv::setNumThreads(threads);
  EXPECT_EQ(cv::countNonZero(many.depth != one.depth), 0);
  EXPECT_EQ(cv::countNonZero(many.ids != one.ids), 0);
}

}  // namespace
}  // namespace horopter::sim
