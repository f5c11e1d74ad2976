// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

#include "tests/sim/oracle/oracle_scene.h"

namespace horopter::sim {
namespace {

using Eigen::Vector3d;

/// Geoms of every type at random poses around the origin, on a plane.
std::string RandomSolids(std::mt19937* random) {
  std::string geoms = R"(<geom type="plane" size="3 2 1" pos="0 0 -1.5"/>)";
  for (const char* shape :
       {R"(type="box" size="0.2 0.3 0.1")", R"(type="cylinder" size="0.2 0.3")",
        R"(type="capsule" size="0.1 0.3")", R"(type="sphere" size="0.25")",
        R"(type="ellipsoid" size="0.1 0.2 0.3")", R"(type="box" size="0.5 0.02 0.4")"}) {
    geoms += fmt::format("<geom {} {}/>", shape,
                         PoseAttributes(RandomPoint(random, 1), RandomRotation(random)));
  }
  return geoms;
}

TEST(OracleRay, AgreesWithMujocosAnalyticRays) {
  std::mt19937 random(41);
  std::map<int, int> hits_of_type;
  int hits = 0, misses = 0, disagreements = 0;
  double worst_flat = 0, worst_round = 0;
  for (int layout = 0; layout < 10; ++layout) {
    OracleScene scene(RandomSolids(&random));
    const mjModel& model = scene.world().model();
    for (int i = 0; i < 150; ++i) {
      const Vector3d from = 4 * RandomPoint(&random, 1).normalized() + Vector3d(0, 0, 1.5);
      const Vector3d direction = (RandomPoint(&random, 1.2) - from).normalized();
      int geom = -1;
      const double theirs = mj_ray(&model, &scene.world().data(), from.data(), direction.data(),
                                   nullptr, 1, -1, &geom);
      const auto ours = scene.oracle().CastRay(from, from + 20 * direction);
      if ((theirs < 0) != !ours.has_value() || (ours && ours->geom != geom)) {
        ++disagreements;
        ADD_FAILURE() << "MuJoCo: geom " << geom << " at " << theirs << ", Bullet: "
                      << (ours ? fmt::format("{} at {}", ours->geom, ours->distance_m) : "nothing");
        continue;
      }
      ours ? ++hits : ++misses;
      if (!ours) continue;
      const int type = model.geom_type[geom];
      ++hits_of_type[type];
      const bool flat = type == mjGEOM_BOX || type == mjGEOM_PLANE;
      double& worst = flat ? worst_flat : worst_round;
      worst = std::max(worst, std::abs(ours->distance_m - theirs) / theirs);
      EXPECT_LT(ours->normal_W.dot(direction), 0) << "the normal points towards the eye";
      EXPECT_NEAR(ours->normal_W.norm(), 1, 1e-9);
      EXPECT_LT((ours->p_W - (from + theirs * direction)).norm(), 1e-3);
    }
  }
  EXPECT_EQ(disagreements, 0);
  EXPECT_GT(hits, 500);
  EXPECT_GT(misses, 50);
  EXPECT_EQ(hits_of_type.size(), 6u) << "every type of geom was hit";
  EXPECT_LT(worst_flat, 1e-7);
  EXPECT_LT(worst_round, 5e-5);
  RecordProperty("worst_flat_relative", fmt::format("{}", worst_flat));
  RecordProperty("worst_round_relative", fmt::format("{}", worst_round));
}

TEST(OracleRay, HitsWhereArithmeticSays) {
  OracleScene scene(R"(
      <geom name="ground" type="plane" size="1 1 1"/>
      <geom name="box" type="box" size="0.1 0.2 0.3" pos="0 0 1"/>
      <geom name="behind" type="box" size="0.1 0.2 0.3" pos="2 0 1"/>)");
  const auto hit = scene.oracle().CastRay({-1, 0, 1}, {3, 0, 1});
  ASSERT_TRUE(hit.has_value());
  EXPECT_EQ(hit->name, "box");
  EXPECT_NEAR(hit->distance_m, 0.9, 1e-7);
  EXPECT_LT((hit->p_W - Vector3d(-0.1, 0, 1)).norm(), 1e-7);
  EXPECT_LT((hit->normal_W - Vector3d(-1, 0, 0)).norm(), 1e-6);
  EXPECT_FALSE(scene.oracle().CastRay({-1, 0, 1}, {-0.11, 0, 1})) << "it ends before the box";
  EXPECT_FALSE(scene.oracle().CastRay({-1, 0, 1}, {-1, 0, 1})) << "it has no length";
  EXPECT_NEAR(scene.oracle().CastRay({0.5, 0.5, 2}, {0.5, 0.5, -1})->distance_m, 2, 1e-12);
  EXPECT_FALSE(scene.oracle().CastRay({0.5, 0.5, -1}, {0.5, 0.5, 0.1})) << "planes have one face";
  EXPECT_FALSE(scene.oracle().CastRay({1.5, 0.5, 1}, {1.5, 0.5, -1})) << "beyond the rectangle";
}

TEST(OracleRay, PassesThroughWhatHoldsTheEyeAndWhatIsIgnored) {
  OracleScene scene(R"(
      <body name="head"><geom name="housing" type="box" size="0.1 0.1 0.1"/>
        <geom name="nose" type="sphere" size="0.05" pos="0.3 0 0"/></body>
      <geom name="wall" type="box" size="0.1 1 1" pos="2 0 0"/>)");
  EXPECT_EQ(scene.oracle().CastRay({0, 0, 0}, {3, 0, 0})->name, "nose");
  EXPECT_EQ(scene.oracle().CastRay({0, 0, 0}, {3, 0, 0}, scene.Body("head"))->name, "wall");
}

}  // namespace
}  // namespace horopter::sim
