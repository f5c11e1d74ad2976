// SPDX-License-Identifier: Apache-2.0
#include "sim/truth/drawn_shape.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <tuple>

#include "tests/sim/truth/truth_scene.h"

namespace horopter::sim {
namespace {

using Eigen::Vector3d;

constexpr const char* kShapes = R"(
<mujoco>
  <visual><quality numslices="48" numstacks="16"/></visual>
  <asset>
    <mesh name="wedge" vertex="0 0 0  .3 0 0  0 .2 0  0 0 .4"/>
    <material name="glass" rgba="1 1 1 0"/>
  </asset>
  <worldbody>
    <geom name="box" type="box" size=".1 .2 .3"/>
    <geom name="ball" type="sphere" size=".2"/>
    <geom name="can" type="cylinder" size=".2 .3"/>
    <geom name="egg" type="ellipsoid" size=".1 .2 .3"/>
    <geom name="pill" type="capsule" size=".1 .3"/>
    <geom name="wedge" type="mesh" mesh="wedge"/>
    <geom name="hidden" type="box" size=".1 .1 .1" group="3"/>
    <geom name="clear" type="box" size=".1 .1 .1" rgba="1 0 0 0"/>
    <geom name="glass" type="box" size=".1 .1 .1" material="glass"/>
    <geom name="tinted" type="box" size=".1 .1 .1" material="glass" rgba="1 0 0 .2"/>
    <geom name="plane" type="plane" size="1 2 .1"/>
    <geom name="endless" type="plane" size="0 0 .1"/>
  </worldbody>
</mujoco>)";

/// Signed volume by the divergence theorem: positive when the facets are seen from outside.
double Volume(const std::vector<Triangle>& triangles) {
  double sum = 0;
  for (const Triangle& t : triangles) sum += t.a.dot(t.b.cross(t.c)) / 6;
  return sum;
}

/// Every edge is walked once in each direction: no hole, no facet the wrong way round.
bool IsClosed(const std::vector<Triangle>& triangles) {
  using Key = std::tuple<long, long, long>;
  const auto key = [](const Vector3d& p) {
    return Key(std::lround(p.x() * 1e9), std::lround(p.y() * 1e9), std::lround(p.z() * 1e9));
  };
  std::map<std::pair<Key, Key>, int> edges;
  for (const Triangle& t : triangles) {
    const Key corners[] = {key(t.a), key(t.b), key(t.c)};
    for (int i = 0; i < 3; ++i) ++edges[{corners[i], corners[(i + 1) % 3]}];
  }
  for (const auto& [edge, count] : edges) {
    const auto back = edges.find({edge.second, edge.first});
    if (count != 1 || back == edges.end()) return false;
  }
  return true;
}

TEST(DrawnShape, SolidsAreClosedAndFillTheirVolumeAsFarAsFacetsCan) {
  TruthScene scene(kShapes);
  const mjModel& model = scene.world().model();
  const struct {
    const char* name;
    double volume;
    double least;  // of it that facets fill
  } cases[] = {
      {"box", 8 * .1 * .2 * .3, 1 - 1e-12},
      {"ball", 4 / 3. * M_PI * .008, 0.98},
      {"can", M_PI * .04 * .6, 0.997},
      {"egg", 4 / 3. * M_PI * .006, 0.98},
      {"pill", 4 / 3. * M_PI * .001 + M_PI * .01 * .6, 0.99},
      {"wedge", .3 * .2 * .4 / 6, 1 - 1e-6},
  };
  for (const auto& c : cases) {
    const auto triangles = DrawnTriangles(model, scene.Geom(c.name));
    EXPECT_TRUE(IsClosed(triangles)) << c.name;
    EXPECT_LE(Volume(triangles), c.volume * (1 + 1e-6)) << c.name;
    EXPECT_GE(Volume(triangles), c.volume * c.least) << c.name;
  }
}

TEST(DrawnShape, CornersOfRoundSolidsLieOnThem) {
  TruthScene scene(kShapes);
  const mjModel& model = scene.world().model();
  for (const Triangle& t : DrawnTriangles(model, scene.Geom("ball"))) {
    for (const Vector3d& p : {t.a, t.b, t.c}) ASSERT_NEAR(p.norm(), 0.2, 1e-12);
  }
  for (const Triangle& t : DrawnTriangles(model, scene.Geom("pill"))) {
    for (const Vector3d& p : {t.a, t.b, t.c}) {
      const double z = std::max(0.0, std::abs(p.z()) - 0.3);
      ASSERT_NEAR(std::hypot(p.x(), p.y(), z), 0.1, 1e-12);
    }
  }
}

TEST(DrawnShape, FacetsLieInsideByNoMoreThanDocumented) {
  TruthScene scene(kShapes);
  const double around = 1 - std::cos(M_PI / 48), along = 1 - std::cos(M_PI / 2 / 16);
  double deepest = 0;
  for (const Triangle& t : DrawnTriangles(scene.world().model(), scene.Geom("ball"))) {
    for (const Vector3d& p : {Vector3d((t.a + t.b + t.c) / 3), Vector3d((t.a + t.c) / 2)}) {
      deepest = std::max(deepest, 1 - p.norm() / 0.2);
    }
  }
  EXPECT_LT(deepest, around + along);
  EXPECT_GT(deepest, along);
}

TEST(DrawnShape, SeesWhatCamerasSee) {
  TruthScene scene(kShapes);
  const mjModel& model = scene.world().model();
  EXPECT_TRUE(IsDrawn(model, scene.Geom("box")));
  EXPECT_TRUE(IsDrawn(model, scene.Geom("tinted")));
  EXPECT_FALSE(IsDrawn(model, scene.Geom("hidden")));
  EXPECT_FALSE(IsDrawn(model, scene.Geom("clear")));
  EXPECT_FALSE(IsDrawn(model, scene.Geom("glass")));
  EXPECT_EQ(scene.shapes()->At(scene.Geom("hidden")), nullptr);
  EXPECT_TRUE(IsTwoSided(model, scene.Geom("plane")));
  EXPECT_FALSE(IsTwoSided(model, scene.Geom("box")));
}

TEST(DrawnShape, PlanesHaveTheirSizeAndEndlessOnesGoOn) {
  TruthScene scene(kShapes);
  for (const Triangle& t : DrawnTriangles(scene.world().model(), scene.Geom("plane"))) {
    EXPECT_EQ(std::abs(t.a.x()), 1);
    EXPECT_EQ(std::abs(t.a.y()), 2);
  }
  const auto endless = DrawnTriangles(scene.world().model(), scene.Geom("endless"));
  EXPECT_GT(std::abs(endless.front().a.x()), 1000);
}

TEST(DrawnShape, NormalsAreThoseOfTheTrueSolid) {
  TruthScene scene(kShapes);
  const mjModel& model = scene.world().model();
  const Vector3d facet(0, 0, 1);
  const Vector3d p(0.08, 0.06, 0.1);
  EXPECT_LT((SurfaceNormal(model, scene.Geom("ball"), p, facet) - p.normalized()).norm(), 1e-12);
  EXPECT_LT(
      (SurfaceNormal(model, scene.Geom("can"), {.2, 0, .1}, {.999, .04, 0}) - Vector3d::UnitX())
          .norm(),
      1e-12);
  EXPECT_EQ(SurfaceNormal(model, scene.Geom("can"), {.1, 0, .3}, facet), facet);
  EXPECT_LT(
      (SurfaceNormal(model, scene.Geom("pill"), {0, .08, .36}, facet) - Vector3d(0, .8, .6)).norm(),
      1e-12);
  EXPECT_LT((SurfaceNormal(model, scene.Geom("egg"), {0, 0, .3}, facet) - facet).norm(), 1e-12);
  EXPECT_EQ(SurfaceNormal(model, scene.Geom("box"), p, facet), facet);
}

TEST(DrawnShape, RefusesAVisibleHeightField) {
  const auto world = World::FromXml(R"(
      <mujoco><asset><hfield name="h" nrow="4" ncol="4" size="1 1 1 .1"/></asset>
        <worldbody><geom type="hfield" hfield="h"/></worldbody></mujoco>)");
  EXPECT_THROW(SceneShapes{world->model()}, SceneError);
}

}  // namespace
}  // namespace horopter::sim
