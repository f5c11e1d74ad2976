// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "tests/sim/oracle/oracle_scene.h"

namespace horopter::sim {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kExact_m = 1e-9;
// On curved surfaces GJK and the expanding polytope converge, rather than end.
constexpr double kRound_m = 1e-6;
constexpr double kRoundOverlap_m = 1e-5;

TEST(OracleDistance, OfBoxesFaceToFaceEdgeToEdgeAndCornerToCorner) {
  OracleScene scene(R"(
      <geom name="a" type="box" size="0.5 0.25 0.1"/>
      <geom name="face" type="box" size="0.2 0.2 0.2" pos="1 0 0"/>
      <geom name="corner" type="box" size="0.2 0.2 0.2" pos="1 1 1"/>
      <geom name="edge" type="box" size="0.2 0.2 0.2" pos="1 1 0"/>
      <geom name="turned" type="box" size="0.2 0.2 0.2" pos="1 0 0" euler="0 0 45"/>
      <geom name="inside" type="box" size="0.2 0.2 0.2" pos="0.65 0 0"/>)");
  EXPECT_NEAR(scene.Distance("a", "face"), 0.3, kExact_m);
  EXPECT_NEAR(scene.Distance("a", "corner"), std::hypot(0.3, 0.55, 0.7), kExact_m);
  EXPECT_NEAR(scene.Distance("a", "edge"), std::hypot(0.3, 0.55), kExact_m);
  EXPECT_NEAR(scene.Distance("a", "turned"), 0.5 - 0.2 * std::sqrt(2), kExact_m);
  EXPECT_NEAR(scene.Distance("a", "inside"), -0.05, kExact_m);
  EXPECT_NEAR(scene.Distance("inside", "a"), -0.05, kExact_m);
}

TEST(OracleDistance, OfABoxAndACylinderAtItsSideCapAndRim) {
  OracleScene scene(R"(
      <geom name="box" type="box" size="0.5 0.5 0.5"/>
      <geom name="side" type="cylinder" size="0.1 0.4" pos="1 0 0"/>
      <geom name="cap" type="cylinder" size="0.1 0.4" pos="0.1 0.2 1"/>
      <geom name="lying" type="cylinder" size="0.1 0.4" pos="1.2 0 0" euler="0 90 0"/>
      <geom name="rim" type="cylinder" size="0.1 0.4" pos="0 0 1.1" euler="45 0 0"/>
      <geom name="edge" type="cylinder" size="0.1 0.4" pos="1 1 0"/>
      <geom name="inside" type="cylinder" size="0.1 0.4" pos="0.58 0 0"/>)");
  EXPECT_NEAR(scene.Distance("box", "side"), 0.4, kRound_m);
  EXPECT_NEAR(scene.Distance("box", "cap"), 0.1, kRound_m);
  EXPECT_NEAR(scene.Distance("box", "lying"), 0.3, kRound_m);
  EXPECT_NEAR(scene.Distance("box", "rim"), 0.6 - (0.1 + 0.4) / std::sqrt(2), kRound_m);
  EXPECT_NEAR(scene.Distance("box", "edge"), std::hypot(0.5, 0.5) - 0.1, kRound_m);
  EXPECT_NEAR(scene.Distance("box", "inside"), -0.02, kRound_m);
}

TEST(OracleDistance, OfRoundSolids) {
  OracleScene scene(R"(
      <geom name="sphere" type="sphere" size="0.3" pos="0 0 2"/>
      <geom name="capsule" type="capsule" size="0.1 0.4"/>
      <geom name="across" type="capsule" size="0.1 0.4" pos="0.5 0 0" euler="90 0 0"/>
      <geom name="ellipsoid" type="ellipsoid" size="0.1 0.2 0.4" pos="1 0 2"/>
      <geom name="overlapping" type="sphere" size="0.3" pos="0 0.5 2"/>)");
  EXPECT_NEAR(scene.Distance("sphere", "capsule"), 2 - 0.3 - 0.5, kRound_m);
  EXPECT_NEAR(scene.Distance("capsule", "across"), 0.3, kRound_m);
  EXPECT_NEAR(scene.Distance("sphere", "ellipsoid"), 1 - 0.3 - 0.1, kRound_m);
  EXPECT_NEAR(scene.Distance("sphere", "overlapping"), -0.1, kRound_m);
}

TEST(OracleDistance, OfRandomlyTurnedSolidsFromAPlane) {
  std::mt19937 random(17);
  for (int i = 0; i < 40; ++i) {
    const Quaterniond q = RandomRotation(&random), plane_q = RandomRotation(&random);
    const Vector3d p = RandomPoint(&random, 1), plane_p = RandomPoint(&random, 1);
    OracleScene scene(fmt::format(
        R"(<geom name="plane" type="plane" size="1 1 1" {1}/>
           <geom name="box" type="box" size="0.1 0.2 0.3" {0}/>
           <geom name="cylinder" type="cylinder" size="0.1 0.3" {0}/>
           <geom name="capsule" type="capsule" size="0.1 0.3" {0}/>
           <geom name="ellipsoid" type="ellipsoid" size="0.1 0.2 0.3" {0}/>)",
        PoseAttributes(p, q), PoseAttributes(plane_p, plane_q)));
    const Vector3d n_G = q.inverse() * (plane_q * Vector3d::UnitZ());
    const double centre = (plane_q * Vector3d::UnitZ()).dot(p - plane_p);
    const double box = n_G.cwiseAbs().dot(Vector3d(0.1, 0.2, 0.3));
    const double cylinder = 0.1 * n_G.head<2>().norm() + 0.3 * std::abs(n_G.z());
    const double ellipsoid = n_G.cwiseProduct(Vector3d(0.1, 0.2, 0.3)).norm();
    EXPECT_NEAR(scene.Distance("box", "plane"), centre - box, kExact_m);
    EXPECT_NEAR(scene.Distance("plane", "cylinder"), centre - cylinder, kExact_m);
    EXPECT_NEAR(scene.Distance("capsule", "plane"), centre - 0.1 - 0.3 * std::abs(n_G.z()),
                kExact_m);
    EXPECT_NEAR(scene.Distance("ellipsoid", "plane"), centre - ellipsoid, kExact_m);
  }
}

/// Distance of a point from a box about the origin.
double FromBox(const Vector3d& p, const Vector3d& half) {
  return (p.cwiseAbs() - half).cwiseMax(0).norm();
}

/// Distance of a point from a cylinder about z.
double FromCylinder(const Vector3d& p, double radius, double half_length) {
  return std::hypot(std::max(p.head<2>().norm() - radius, 0.0),
                    std::max(std::abs(p.z()) - half_length, 0.0));
}

double Tolerance(double distance_m) { return distance_m < 0 ? kRoundOverlap_m : kRound_m; }

TEST(OracleDistance, OfSpheresFromRandomlyTurnedSolids) {
  std::mt19937 random(23);
  int apart = 0;
  for (int i = 0; i < 200; ++i) {
    const Quaterniond q = RandomRotation(&random);
    const Vector3d p = RandomPoint(&random, 1), centre = RandomPoint(&random, 2);
    OracleScene scene(fmt::format(
        R"(<geom name="box" type="box" size="0.1 0.2 0.3" {0}/>
           <geom name="cylinder" type="cylinder" size="0.2 0.3" {0}/>
           <geom name="ball" type="sphere" size="0.15" pos="{1:.17g} {2:.17g} {3:.17g}"/>)",
        PoseAttributes(p, q), centre.x(), centre.y(), centre.z()));
    const Vector3d p_G = q.inverse() * (centre - p);
    const double box = FromBox(p_G, {0.1, 0.2, 0.3}), cylinder = FromCylinder(p_G, 0.2, 0.3);
    if (std::min(box, cylinder) < 1e-3) continue;  // the centre is inside
    ++apart;
    EXPECT_NEAR(scene.Distance("box", "ball"), box - 0.15, Tolerance(box - 0.15));
    EXPECT_NEAR(scene.Distance("cylinder", "ball"), cylinder - 0.15, Tolerance(cylinder - 0.15));
  }
  EXPECT_GT(apart, 150);
}

TEST(OracleDistance, OfRandomlyTurnedBoxesIsThatOfTheirSampledSurfaces) {
  // The distance of two polytopes is attained at a vertex of one and a face of the other, or at
  // two edges: sample the edges of each densely against the exact point-box distance.
  std::mt19937 random(29);
  const Vector3d half_a(0.3, 0.2, 0.1), half_b(0.15, 0.25, 0.2);
  const auto sampled = [](const Quaterniond& q, const Vector3d& p, const Vector3d& edges_of,
                          const Vector3d& half) {  // box `edges_of` at (p, q) from one at origin
    double least = 1e9;
    for (int axis = 0; axis < 3; ++axis) {
      for (int corner = 0; corner < 4; ++corner) {
        for (int k = 0; k <= 400; ++k) {
          Vector3d v = edges_of;
          v[axis] *= k / 200.0 - 1;
          v[(axis + 1) % 3] *= corner & 1 ? 1 : -1;
          v[(axis + 2) % 3] *= corner & 2 ? 1 : -1;
          least = std::min(least, FromBox(p + q * v, half));
        }
      }
    }
    return least;
  };
  for (int i = 0; i < 60; ++i) {
    const Quaterniond qa = RandomRotation(&random), qb = RandomRotation(&random);
    const Vector3d pa = RandomPoint(&random, 0.5),
                   pb = RandomPoint(&random, 0.5) + Vector3d(1, 0, 0);
    OracleScene scene(fmt::format(
        R"(<geom name="a" type="box" size="0.3 0.2 0.1" {}/>
           <geom name="b" type="box" size="0.15 0.25 0.2" {}/>)",
        PoseAttributes(pa, qa), PoseAttributes(pb, qb)));
    const double b_from_a = sampled(qa.inverse() * qb, qa.inverse() * (pb - pa), half_b, half_a);
    const double a_from_b = sampled(qb.inverse() * qa, qb.inverse() * (pa - pb), half_a, half_b);
    const double expected = std::min(a_from_b, b_from_a);
    const double distance = scene.Distance("a", "b");
    if (expected == 0) {
      EXPECT_LT(distance, 0);
    } else {
      // Sampling can only overestimate: by a quarter of the spacing squared over the distance.
      EXPECT_LE(distance, expected + kExact_m);
      EXPECT_GE(distance, expected - 2e-6 / expected - kExact_m);
    }
  }
}

TEST(OracleDistance, RefusesGeomsThatCannotCollideAndHeightFields) {
  OracleScene scene(R"(<geom name="a" type="sphere" size="1"/>
      <geom name="visual" type="sphere" size="1" contype="0" conaffinity="0"/>)");
  EXPECT_THROW(scene.Distance("a", "visual"), std::out_of_range);
  EXPECT_THROW(scene.oracle().Distance(0, 99), std::out_of_range);
  const auto world = World::FromXml(
      R"(<mujoco><asset><hfield name="h" nrow="3" ncol="3" size="1 1 1 1"/></asset>
         <worldbody><geom name="hills" type="hfield" hfield="h"/></worldbody></mujoco>)");
  try {
    const CollisionOracle oracle(world->model());
    FAIL() << "accepted a height field";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("hills"), std::string::npos);
  }
}

}  // namespace
}  // namespace horopter::sim
