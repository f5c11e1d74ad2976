// SPDX-License-Identifier: Apache-2.0
#include "sim/oracle/bullet_queries.h"

#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include <algorithm>

namespace horopter::sim {
namespace {

ClosestPoints ClosestToPoint(const PlacedShape& solid, const btVector3& p_W) {
  const btSphereShape point(0);
  const btTransform X_WP(btMatrix3x3::getIdentity(), p_W);
  return Closest({&point, X_WP}, solid);
}

}  // namespace

ClosestPoints Closest(const PlacedShape& a, const PlacedShape& b) {
  btVoronoiSimplexSolver simplex;
  btGjkEpaPenetrationDepthSolver penetration;
  btGjkPairDetector detector(a.shape, b.shape, &simplex, &penetration);
  btGjkPairDetector::ClosestPointInput input;
  input.m_transformA = a.X_WG;
  input.m_transformB = b.X_WG;
  btPointCollector found;
  detector.getClosestPoints(input, found, nullptr);

  ClosestPoints closest;
  if (!found.m_hasResult) {  // Bullet's way to say that they touch to the last bit
    closest.p_WA = closest.p_WB = a.X_WG.getOrigin();
    closest.n_BA_W = btVector3(0, 0, 1);
    return closest;
  }
  closest.distance_m = found.m_distance;
  closest.p_WB = found.m_pointInWorld;
  closest.n_BA_W = found.m_normalOnBInWorld;
  closest.p_WA = closest.p_WB + closest.n_BA_W * closest.distance_m;
  return closest;
}

ClosestPoints ClosestToPlane(const PlacedShape& a, const btTransform& X_WP) {
  ClosestPoints closest;
  closest.n_BA_W = X_WP.getBasis().getColumn(2);
  const btVector3 down_G = a.X_WG.getBasis().transpose() * -closest.n_BA_W;
  closest.p_WA = a.X_WG * a.shape->localGetSupportingVertex(down_G);
  closest.distance_m = closest.n_BA_W.dot(closest.p_WA - X_WP.getOrigin());
  closest.p_WB = closest.p_WA - closest.n_BA_W * closest.distance_m;
  return closest;
}

double DistanceAtLeast(const PlacedShape& a, const PlacedShape& b) {
  btVector3 lower_a, upper_a, lower_b, upper_b;
  a.shape->getAabb(a.X_WG, lower_a, upper_a);
  b.shape->getAabb(b.X_WG, lower_b, upper_b);
  btVector3 gap = lower_a - upper_b;
  gap.setMax(lower_b - upper_a);
  gap.setMax(btVector3(0, 0, 0));
  return gap.length();
}

std::optional<RayEntry> CastRay(const PlacedShape& solid, const btVector3& from_W,
                                const btVector3& direction_W, double length_m) {
  constexpr double kTouch_m = 1e-8;
  constexpr int kMaxSteps = 200;
  double outside = 0;
  for (int step = 0; step < kMaxSteps; ++step) {
    const ClosestPoints closest = ClosestToPoint(solid, from_W + direction_W * outside);
    if (closest.distance_m <= kTouch_m) {
      if (step == 0) return std::nullopt;
      return RayEntry{outside, closest.n_BA_W};
    }
    const double approach = -closest.n_BA_W.dot(direction_W);
    if (approach <= 0) return std::nullopt;
    double next = outside + closest.distance_m / approach;
    // On a curved surface GJK's normal is less exact than its distance, and a step may go too far.
    double inside = next;
    while (ClosestToPoint(solid, from_W + direction_W * next).distance_m < -kTouch_m &&
           inside - outside > kTouch_m) {
      inside = next;
      next = (outside + inside) / 2;
    }
    outside = next;
    if (outside > length_m) return std::nullopt;
  }
  return std::nullopt;  // grazes along the surface: neither in nor out
}

}  // namespace horopter::sim
