// SPDX-License-Identifier: Apache-2.0
#include "sim/truth/scene_snapshot.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>

#include "sim/render/renderer.h"
#include "tests/sim/truth/truth_scene.h"

namespace horopter::sim {
namespace {

using Eigen::Vector3d;
using hardware::CameraModel;
using hardware::Pose;

TEST(SceneSnapshot, AgreesWithAnalyticRaysOnFlatSurfaces) {
  TruthScene scene(kBoxes);
  const SceneSnapshot now = scene.Now();
  const EyeView view = VergedLeft(CameraModel::FromHorizontalFov(320, 240, 60 * kDegree));
  int hits = 0;
  for (int y = 0; y < 240; y += 3) {
    for (int x = 0; x < 320; x += 3) {
      const Ray ray = PixelRay(view, x + 0.3, y - 0.2);
      const auto [theirs, geom] = CastAnalytic(scene.world(), ray);
      const auto ours = now.FirstHit(ray, 0.03, 200);
      ASSERT_EQ(ours.has_value(), theirs >= 0);
      if (!ours) continue;
      ++hits;
      ASSERT_EQ(ours->geom, geom);
      ASSERT_NEAR(ours->t, theirs, 1e-9 * theirs);
      ASSERT_LT(ours->facet_normal_W.dot(ray.direction), 0);
    }
  }
  EXPECT_GT(hits, 8000);
}

/// Pixels where ids agree, and the largest relative difference in depth among them.
struct Agreement {
  double same_part = 0;
  double depth = 0;
};

Agreement WithRenderer(TruthScene& scene, const EyeView& view) {
  Renderer renderer(scene.world(), {.width = 320, .height = 240});
  const RenderedView drawn =
      renderer.Render(view.X_WC, view.camera, {.rgb = false, .depth = true, .ids = true});
  const EyeTruth truth = CaptureEyeTruth(scene.Now(), view);
  Agreement agreement;
  int same = 0;
  for (int y = 0; y < truth.ids.rows; ++y) {
    for (int x = 0; x < truth.ids.cols; ++x) {
      if (truth.ids(y, x) != drawn.ids(y, x)) continue;
      ++same;
      if (truth.ids(y, x) < 0) continue;
      agreement.depth =
          std::max(agreement.depth, std::abs(drawn.depth(y, x) / double{truth.depth(y, x)} - 1));
    }
  }
  agreement.same_part = same / static_cast<double>(truth.ids.total());
  return agreement;
}

TEST(SceneSnapshot, IsWhatTheRendererDrawsFlatOrRound) {
  const auto camera = CameraModel::FromHorizontalFov(320, 240, 50 * kDegree);
  for (const char* mjcf : {kBoxes, kRound}) {
    TruthScene scene(mjcf);
    const Agreement agreement = WithRenderer(scene, VergedLeft(camera));
    EXPECT_GT(agreement.same_part, 0.9999);
    EXPECT_LT(agreement.depth, 1e-4);
    RecordProperty("depth", std::to_string(agreement.depth));
  }
}

TEST(SceneSnapshot, RoundShapesLieInsideTheTrueOnesByWhatFacetsLeave) {
  TruthScene scene(kRound);
  const SceneSnapshot now = scene.Now();
  const EyeView view = VergedLeft(CameraModel::FromHorizontalFov(320, 240, 50 * kDegree));
  double deepest_m = 0;
  int compared = 0;
  for (int y = 0; y < 240; ++y) {
    for (int x = 0; x < 320; ++x) {
      const Ray ray = PixelRay(view, x, y);
      const auto [theirs, geom] = CastAnalytic(scene.world(), ray);
      const auto ours = now.FirstHit(ray, 0.03, 200);
      ASSERT_TRUE(ours && theirs > 0);
      if (ours->geom != geom) continue;  // a silhouette
      // Along the surface's normal, so that grazing rays say nothing special.
      const double inside = (ours->t - theirs) * -ours->facet_normal_W.dot(ray.direction);
      ASSERT_GT(inside, -1e-9);
      deepest_m = std::max(deepest_m, inside);
      ++compared;
    }
  }
  EXPECT_GT(compared, 70000);
  // 1 - cos(pi/48) + 1 - cos(pi/32) of a radius of at most 0.2 m.
  EXPECT_LT(deepest_m, 0.2 * 0.00695);
  EXPECT_GT(deepest_m, 0.1 * 0.002);
}

TEST(SceneSnapshot, KeepsItsInstantWhenTheWorldMovesOn) {
  TruthScene scene(R"(
      <mujoco><worldbody>
        <body name="cart" pos="2 0 0"><joint name="x" type="slide" axis="1 0 0"/>
          <geom name="cart" type="box" size=".1 .1 .1"/></body>
      </worldbody></mujoco>)");
  const SceneSnapshot before = scene.Now();
  scene.world().mutable_data().qpos[0] = 0.5;
  scene.world().Forward();
  const SceneSnapshot after = scene.Now();
  const Ray ray({0, 0, 0}, {1, 0, 0});
  EXPECT_NEAR(before.FirstHit(ray, 0, 10)->t, 1.9, 1e-12);
  EXPECT_NEAR(after.FirstHit(ray, 0, 10)->t, 2.4, 1e-12);
  EXPECT_FALSE(after.FirstHit(ray, 0, 2.3)) << "beyond the limit";
  EXPECT_FALSE(after.FirstHit(ray, 2.5, 10)) << "its far side is seen from inside";
}

TEST(SceneSnapshot, ALikelyGeomChangesNothingButTime) {
  TruthScene scene(kBoxes);
  const SceneSnapshot now = scene.Now();
  const EyeView view = VergedRight(CameraModel::FromHorizontalFov(64, 48, 60 * kDegree));
  for (int y = 0; y < 48; ++y) {
    for (int x = 0; x < 64; ++x) {
      const auto plain = now.FirstHit(PixelRay(view, x, y), 0.03, 200);
      ASSERT_TRUE(plain.has_value());
      for (int likely = 0; likely < scene.shapes()->geom_count(); ++likely) {
        const auto guessed = now.FirstHit(PixelRay(view, x, y), 0.03, 200, likely);
        ASSERT_EQ(guessed->geom, plain->geom);
        ASSERT_EQ(guessed->t, plain->t);
      }
    }
  }
}

TEST(SceneSnapshot, APlaneIsSeenFromBothSidesAndASolidFromOutside) {
  TruthScene scene(R"(
      <mujoco><worldbody>
        <geom name="plane" type="plane" size="1 1 .1"/>
        <geom name="box" type="box" size=".2 .2 .2" pos="0 0 2"/>
      </worldbody></mujoco>)");
  const SceneSnapshot now = scene.Now();
  EXPECT_EQ(now.FirstHit(Ray({.5, .5, 1}, {0, 0, -1}), 0, 10)->geom, scene.Geom("plane"));
  EXPECT_EQ(now.FirstHit(Ray({.5, .5, -1}, {0, 0, 1}), 0, 10)->geom, scene.Geom("plane"));
  EXPECT_FALSE(now.FirstHit(Ray({0, 0, 2}, {0, 0, 1}), 0, 10)) << "from inside the box";
}

}  // namespace
}  // namespace horopter::sim
