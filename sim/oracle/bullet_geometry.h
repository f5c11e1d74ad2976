// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <BulletCollision/CollisionShapes/btConvexShape.h>
#include <mujoco/mujoco.h>

#include <memory>
#include <string>

#include "hardware/types/pose.h"

namespace horopter::sim {

/// Orientation crosses between MuJoCo (wxyz), Eigen and Bullet (both xyzw) as a rotation matrix
/// and nowhere as a quaternion, so that there is no order to mistake.
btTransform ToBullet(const hardware::Pose& X_AB);
btVector3 ToBullet(const Eigen::Vector3d& p);
Eigen::Vector3d FromBullet(const btVector3& p);

/// Pose from MuJoCo's position and row-major rotation matrix (geom_xpos and geom_xmat, ...).
hardware::Pose PoseFromMujoco(const mjtNum position[3], const mjtNum rotation[9]);

/// The convex shape of a geom in the geom's own frame (cylinders and capsules along z), with a
/// collision margin of zero wherever Bullet's margin would round corners off, so that distances
/// are those of the exact solid. An ellipsoid has its exact support mapping; a mesh is its convex
/// hull, as MuJoCo collides it.
/// @return null for a plane, which is not a convex solid.
/// @throws std::invalid_argument naming a geom of a type that has no such shape (height field).
std::unique_ptr<btConvexShape> MakeConvexShape(const mjModel& model, int geom);

/// What a robot stands on, and so no obstacle: geoms named "floor" or of a body named "floor", and
/// planes of the world that face up (within 10 degrees). Other planes are walls.
bool IsFloor(const mjModel& model, int geom);

/// The geom's name, or where to find it when it has none: "geom 12 of body 'shelf'".
std::string GeomLabel(const mjModel& model, int geom);

}  // namespace horopter::sim
