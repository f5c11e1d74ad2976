// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "sim/render/renderer.h"

namespace horopter::sim {
namespace {

using hardware::CameraModel;
using hardware::Pose;

// A room of flat surfaces only, where MuJoCo's analytic rays and the drawn triangles agree.
constexpr const char* kFlatRoom = R"(
<mujoco>
  <worldbody>
    <light pos="0 0 2.8" dir="0 0 -1"/>
    <geom name="floor" type="plane" size="3 3 .1" rgba=".5 .5 .5 1"/>
    <geom name="north" type="box" pos="3 0 1.5" size=".05 3 1.5"/>
    <geom name="west" type="box" pos="0 3 1.5" size="3 .05 1.5"/>
    <geom name="crate" type="box" pos="1.2 .3 .3" size=".2 .3 .3" euler="10 20 30"/>
    <geom name="glass" type="box" pos="1 -1 .5" size=".3 .02 .5" euler="0 0 40" rgba="0 0 1 .3"/>
    <geom name="hidden" type="box" pos=".6 0 .9" size=".1 .1 .1" group="3"/>
    <site name="mark" type="box" pos=".6 .2 .9" size=".1 .1 .1"/>
  </worldbody>
</mujoco>)";

struct RayHit {
  double depth;  // in multiples of the ray's z, which is 1
  int geom;
};

RayHit CastRay(const World& world, const Pose& X_WC, const Eigen::Vector3d& direction_C) {
  const Eigen::Vector3d direction_W = X_WC.linear() * direction_C;
  constexpr mjtByte kGroups[mjNGROUP] = {1, 1, 1, 0, 0, 0};
  int geom = -1;
  const double t = mj_ray(&world.model(), &world.data(), X_WC.translation().data(),
                          direction_W.data(), kGroups, 1, -1, &geom);
  return {t, geom};
}

/// Somewhere in the room, looking about north-west, rolled.
Pose RandomPose(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  Pose X = Pose::Identity();
  X.translation() << -1 + unit(random), -1 + unit(random), 1.2 + 0.5 * unit(random);
  X.linear() = (Eigen::AngleAxisd(0.6 + 0.5 * unit(random), Eigen::Vector3d::UnitZ()) *
                Eigen::AngleAxisd(0.3 + 0.3 * unit(random), Eigen::Vector3d::UnitY()) *
                Eigen::AngleAxisd(0.5 * unit(random), Eigen::Vector3d::UnitX()))
                   .toRotationMatrix() *
               hardware::OpticalToBody();
  return X;
}

/// All pixels around show one object, so that the pixel is no edge.
bool InsideOneObject(const cv::Mat1i& ids, int x, int y) {
  for (int v = std::max(0, y - 1); v <= std::min(ids.rows - 1, y + 1); ++v) {
    for (int u = std::max(0, x - 1); u <= std::min(ids.cols - 1, x + 1); ++u) {
      if (ids(v, u) != ids(y, x)) return false;
    }
  }
  return true;
}

/// Compares depth and ids with rays at random pixel centres.
void ExpectAgreesWithRays(World& world, Renderer& renderer, const Pose& X_WC,
                          const CameraModel& camera, std::mt19937& random) {
  constexpr int kPixels = 400;
  const RenderedView view =
      renderer.Render(X_WC, camera, {.rgb = false, .depth = true, .ids = true});
  std::uniform_int_distribution<int> column(0, camera.width() - 1);
  std::uniform_int_distribution<int> row(0, camera.height() - 1);
  int compared = 0;
  double worst = 0;
  for (int i = 0; i < kPixels; ++i) {
    const int x = column(random), y = row(random);
    const RayHit hit = CastRay(world, X_WC, *camera.Unproject({x, y}));
    if (view.ids(y, x) != hit.geom) {  // an edge passes through the pixel
      EXPECT_FALSE(InsideOneObject(view.ids, x, y)) << "pixel " << x << ", " << y;
      continue;
    }
    ++compared;
    if (hit.geom < 0) {
      EXPECT_TRUE(std::isinf(view.depth(y, x)));
      continue;
    }
    worst = std::max(worst, std::abs(view.depth(y, x) / hit.depth - 1));
  }
  EXPECT_LT(worst, 1e-4);
  EXPECT_GT(compared, kPixels * 98 / 100);
}

TEST(RendererDepth, AgreesWithRaysForAnyPoseAndFieldOfView) {
  const auto world = World::FromXml(kFlatRoom);
  Renderer renderer(*world, {.width = 320, .height = 240});
  std::mt19937 random(11);
  for (const double fov_deg : {14.0, 34.0, 60.0, 100.0}) {
    const auto camera = CameraModel::FromHorizontalFov(320, 240, fov_deg * M_PI / 180);
    for (int i = 0; i < 4; ++i) {
      SCOPED_TRACE(testing::Message() << fov_deg << " deg, pose " << i);
      ExpectAgreesWithRays(*world, renderer, RandomPose(random), camera, random);
    }
  }
}

TEST(RendererDepth, AgreesWithRaysForAnyPrincipalPoint) {
  const auto world = World::FromXml(kFlatRoom);
  Renderer renderer(*world, {.width = 320, .height = 240});
  std::mt19937 random(12);
  for (const auto& [cx, cy] : {std::pair{150.3, 131.7}, {20.0, 230.0}, {319.5, -60.0}}) {
    const CameraModel camera({320, 240, 280, 280, cx, cy});
    for (int i = 0; i < 3; ++i) {
      SCOPED_TRACE(testing::Message() << cx << ", " << cy << ", pose " << i);
      ExpectAgreesWithRays(*world, renderer, RandomPose(random), camera, random);
    }
  }
}

TEST(RendererDepth, AgreesWithRaysForOddSizesAndSmallerViews) {
  const auto world = World::FromXml(kFlatRoom);
  Renderer renderer(*world, {.width = 400, .height = 300});
  std::mt19937 random(13);
  for (const auto& [width, height] : {std::pair{317, 211}, {64, 300}, {400, 1}}) {
    const auto camera = CameraModel::FromHorizontalFov(width, height, 1.0);
    SCOPED_TRACE(testing::Message() << width << "x" << height);
    ExpectAgreesWithRays(*world, renderer, RandomPose(random), camera, random);
  }
}

TEST(RendererDepth, AgreesWithRaysOnAnInfinitePlane) {
  const auto world = World::FromXml(
      R"(<mujoco><worldbody><geom type="plane" size="0 0 1"/></worldbody></mujoco>)");
  Renderer renderer(*world, {.width = 320, .height = 240});
  std::mt19937 random(14);
  for (int i = 0; i < 3; ++i) {
    Pose X_WC = RandomPose(random);
    X_WC.translation() += Eigen::Vector3d(37, -21, 0);
    X_WC.linear() = Eigen::AngleAxisd(0.8, -X_WC.linear()
                                                .col(0)
                                                .cross(Eigen::Vector3d::UnitZ())
                                                .cross(Eigen::Vector3d::UnitZ())
                                                .normalized())
                        .toRotationMatrix() *
                    X_WC.linear();
    const auto camera = CameraModel::FromHorizontalFov(320, 240, 0.5);
    ExpectAgreesWithRays(*world, renderer, X_WC, camera, random);
  }
}

TEST(RendererDepth, NothingIsInfinitelyFarAndHasNoId) {
  const auto world = World::FromXml(R"(
      <mujoco>
        <asset><texture type="skybox" builtin="gradient" rgb1="1 0 0" rgb2="0 0 1" width="32"
                        height="192"/></asset>
        <worldbody><geom type="box" pos="2 0 0" size=".1 .1 .1"/></worldbody>
      </mujoco>)");
  Renderer renderer(*world, {.width = 80, .height = 60});
  Pose X_WC = Pose::Identity();
  X_WC.linear() = hardware::OpticalToBody();
  const auto view = renderer.Render(X_WC, CameraModel::FromHorizontalFov(80, 60, 1.0),
                                    {.rgb = true, .depth = true, .ids = true});
  EXPECT_TRUE(std::isinf(view.depth(0, 0)));
  EXPECT_EQ(view.ids(0, 0), -1);
  EXPECT_EQ(view.ids(30, 40), 0);
  EXPECT_NEAR(view.depth(30, 40), 1.9, 1e-4);
}

TEST(RendererDepth, NearAndFarPlanesBoundWhatIsSeen) {
  const auto world = World::FromXml(
      R"(<mujoco><worldbody><geom type="box" pos="2 0 0" size=".1 9 9"/></worldbody></mujoco>)");
  Pose X_WC = Pose::Identity();
  X_WC.linear() = hardware::OpticalToBody();
  const auto camera = CameraModel::FromHorizontalFov(8, 8, 0.5);
  const auto depth_with = [&](double near_m, double far_m) {
    Renderer renderer(*world, {.width = 8, .height = 8, .near_m = near_m, .far_m = far_m});
    return renderer.Render(X_WC, camera, {.rgb = false, .depth = true}).depth(4, 4);
  };
  EXPECT_NEAR(depth_with(0.01, 50), 1.9, 1e-4);
  EXPECT_NEAR(depth_with(0.5, 2), 1.9, 1e-5);
  EXPECT_TRUE(std::isinf(depth_with(0.01, 1.8)));
}

}  // namespace
}  // namespace horopter::sim
