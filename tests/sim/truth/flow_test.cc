// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>

#include "sim/truth/correspondence.h"
#include "tests/sim/truth/truth_scene.h"

namespace horopter::sim {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using hardware::CameraModel;
using hardware::Pose;

/// A cart on rails across the view, a door that turns, and a wall behind them.
constexpr const char* kMoving = R"(
<mujoco>
  <worldbody>
    <geom name="wall" type="box" pos="3 0 1" size=".05 4 4"/>
    <body name="cart" pos="1.5 0 1"><joint name="y" type="slide" axis="0 1 0"/>
      <geom name="cart" type="box" size=".1 .2 .2"/></body>
    <body name="door" pos="2 -.8 1"><joint name="turn" type="hinge" axis="0 0 1"/>
      <geom name="door" type="box" size=".02 .3 .4" pos="0 .3 0"/></body>
  </worldbody>
</mujoco>)";

EyeView Still(const CameraModel& camera) { return {EyePose({0, 0, 1}, 0, 0, 0), camera}; }

TEST(TrueFlow, IsZeroWhileNothingMoves) {
  TruthScene scene(kMoving);
  const EyeView view = Still(DistortedCamera());
  const SceneSnapshot now = scene.Now();
  const auto flow = TrueFlow(now, CaptureEyeTruth(now, view), now, view);
  EXPECT_LT(cv::norm(flow.dx, cv::NORM_INF), 1e-6);
  EXPECT_LT(cv::norm(flow.dy, cv::NORM_INF), 1e-6);
  EXPECT_EQ(cv::countNonZero(flow.Mask(Visibility::kVisible)), 160 * 120);
}

/// Flow of a camera that turns about its optical centre depends on no depth: K R K^-1 (Longuet-
/// Higgins and Prazdny 1980, the rotational part, for a finite turn).
TEST(TrueFlow, UnderHeadRotationIsTheRotationsOwnWhateverIsSeen) {
  TruthScene scene(kMoving);
  for (const CameraModel& camera :
       {CameraModel::FromHorizontalFov(160, 120, 60 * kDegree), DistortedCamera()}) {
    const EyeView before{EyePose({0, 0, 1}, 2 * kDegree, 1 * kDegree, 0), camera};
    const EyeView after{EyePose({0, 0, 1}, -3 * kDegree, 4 * kDegree, 10 * kDegree), camera};
    const SceneSnapshot now = scene.Now();
    const auto flow = TrueFlow(now, CaptureEyeTruth(now, before), now, after);
    const Eigen::Matrix3d R = after.X_WC.linear().transpose() * before.X_WC.linear();
    for (int y = 0; y < 120; ++y) {
      for (int x = 0; x < 160; ++x) {
        const auto there = camera.Project(R * *camera.Unproject(Vector2d(x, y)));
        ASSERT_TRUE(there.has_value());
        ASSERT_NEAR(x + flow.dx(y, x), there->x(), 1e-4);
        ASSERT_NEAR(y + flow.dy(y, x), there->y(), 1e-4);
        ASSERT_NE(flow.at(y, x), Visibility::kOccluded) << "turning uncovers nothing";
      }
    }
  }
}

TEST(TrueFlow, PointsMoveWithTheirBody) {
  TruthScene scene(kMoving);
  const auto camera = CameraModel::FromHorizontalFov(160, 120, 60 * kDegree);
  const EyeView view = Still(camera);
  const SceneSnapshot then = scene.Now();
  const EyeTruth seen = CaptureEyeTruth(then, view);
  scene.world().mutable_data().qpos[0] = 0.15;
  scene.world().mutable_data().qpos[1] = 0.4;
  scene.world().Forward();
  const auto flow = TrueFlow(then, seen, scene.Now(), view);
  int cart = 0, door = 0, wall = 0;
  for (int y = 0; y < 120; ++y) {
    for (int x = 0; x < 160; ++x) {
      const Vector3d p_W =
          view.X_WC * (*camera.Unproject(Vector2d(x, y)) * double{seen.depth(y, x)});
      Vector3d moved = p_W;
      if (seen.ids(y, x) == scene.Geom("cart")) {
        ++cart;
        moved.y() += 0.15;
      } else if (seen.ids(y, x) == scene.Geom("door")) {
        ++door;
        const Vector3d hinge(2, -0.8, 0);
        moved = hinge + Eigen::AngleAxisd(0.4, Vector3d::UnitZ()) * (p_W - hinge);
      } else {
        ++wall;
      }
      const auto there = camera.Project(view.X_WC.inverse() * moved);
      ASSERT_TRUE(there.has_value());
      ASSERT_NEAR(x + flow.dx(y, x), there->x(), 1e-4);
      ASSERT_NEAR(y + flow.dy(y, x), there->y(), 1e-4);
    }
  }
  EXPECT_GT(cart, 300);
  EXPECT_GT(door, 300);
  EXPECT_GT(wall, 3000);
}

TEST(TrueFlow, WhatAMovingThingCoversIsOccludedAndWhatItUncoversWas) {
  TruthScene scene(kMoving);
  const auto camera = CameraModel::FromHorizontalFov(160, 120, 60 * kDegree);
  const EyeView view = Still(camera);
  const SceneSnapshot then = scene.Now();
  const EyeTruth seen_then = CaptureEyeTruth(then, view);
  scene.world().mutable_data().qpos[0] = 0.15;
  scene.world().Forward();
  const SceneSnapshot now = scene.Now();
  const EyeTruth seen_now = CaptureEyeTruth(now, view);
  const cv::Mat1b covered = TrueFlow(then, seen_then, now, view).Mask(Visibility::kOccluded);
  const cv::Mat1b uncovered = TrueFlow(now, seen_now, then, view).Mask(Visibility::kOccluded);
  const int cart = scene.Geom("cart");
  const cv::Mat1b cart_then = seen_then.ids == cart, cart_now = seen_now.ids == cart;
  // The camera stands still: covered is the background that the cart now stands before. Of the
  // cart itself nothing hides but its flank, which turns away from the eye.
  EXPECT_EQ(cv::countNonZero(covered & ~cart_then), cv::countNonZero(cart_now & ~cart_then));
  EXPECT_EQ(cv::countNonZero(uncovered & ~cart_now), cv::countNonZero(cart_then & ~cart_now));
  EXPECT_EQ(cv::countNonZero((covered & ~cart_then) != (cart_now & ~cart_then)), 0);
  EXPECT_GT(cv::countNonZero(covered), 300);
}

TEST(TrueFlow, ThereAndBackIsNothing) {
  TruthScene scene(kMoving);
  const EyeView before{EyePose({0, 0, 1}, 0, 0, 0), DistortedCamera()};
  const EyeView after{EyePose({0.1, 0.05, 1.02}, 2 * kDegree, 1 * kDegree, 5 * kDegree),
                      DistortedCamera()};
  const SceneSnapshot then = scene.Now();
  scene.world().mutable_data().qpos[0] = 0.05;
  scene.world().mutable_data().qpos[1] = 0.2;
  scene.world().Forward();
  const SceneSnapshot now = scene.Now();
  const auto flow = TrueFlow(then, CaptureEyeTruth(then, before), now, after);
  int compared = 0;
  for (int y = 0; y < 120; y += 7) {
    for (int x = 0; x < 160; x += 7) {
      if (flow.at(y, x) != Visibility::kVisible) continue;
      hardware::Intrinsics in = after.camera.intrinsics();
      in.cx -= x + double{flow.dx(y, x)};
      in.cy -= y + double{flow.dy(y, x)};
      in.width = in.height = 1;
      EyeView spot = after;
      spot.camera = CameraModel(in, after.camera.distortion());
      const auto back = TrueFlow(now, CaptureEyeTruth(now, spot), then, before);
      if (back.at(0, 0) != Visibility::kVisible) continue;
      ++compared;
      ASSERT_NEAR(back.dx(0, 0), x, 0.01);
      ASSERT_NEAR(back.dy(0, 0), y, 0.01);
    }
  }
  EXPECT_GT(compared, 250);
}

}  // namespace
}  // namespace horopter::sim
