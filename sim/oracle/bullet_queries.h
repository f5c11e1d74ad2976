// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <BulletCollision/CollisionShapes/btConvexShape.h>

#include <optional>

namespace horopter::sim {

/// A convex solid at its place in the world.
struct PlacedShape {
  const btConvexShape* shape;
  btTransform X_WG;
};

/// Where two solids are nearest to each other, or deepest inside.
struct ClosestPoints {
  double distance_m = 0;  ///< negative: depth of penetration
  btVector3 p_WA;         ///< on the first solid
  btVector3 p_WB;         ///< on the second
  btVector3 n_BA_W;       ///< unit vector from the second towards the first
};

/// Distance of two convex solids: GJK when apart (Gilbert, Johnson & Keerthi 1988), the expanding
/// polytope algorithm when they overlap (van den Bergen 2001), both Bullet's.
ClosestPoints Closest(const PlacedShape& a, const PlacedShape& b);

/// Signed distance of a convex solid from the half-space below a plane that goes through the
/// origin of X_WP, with its normal along z.
ClosestPoints ClosestToPlane(const PlacedShape& a, const btTransform& X_WP);

/// A lower bound of their distance, from their axis-aligned bounding boxes.
double DistanceAtLeast(const PlacedShape& a, const PlacedShape& b);

/// Where a ray enters a solid.
struct RayEntry {
  double distance_m = 0;  ///< along the ray
  btVector3 normal_W;
};

/// Casts a ray from `from_W` along the unit vector `direction_W` by conservative advancement (van
/// den Bergen 2004): each step goes to the plane that separates the ray's tip from the solid, and
/// is halved while it ends inside, until the tip touches within 1e-8 m.
/// @return nothing when it misses within `length_m`, or when `from_W` is not outside the solid.
std::optional<RayEntry> CastRay(const PlacedShape& solid, const btVector3& from_W,
                                const btVector3& direction_W, double length_m);

}  // namespace horopter::sim
