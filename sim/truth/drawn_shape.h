// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <vector>

namespace horopter::sim {

/// One flat facet, seen from the side where a, b, c turn counter-clockwise.
struct Triangle {
  Eigen::Vector3d a, b, c;
};

/// Whether cameras see the geom at all: visible groups are 0 to 2 (as Renderer's), and not fully
/// transparent.
bool IsDrawn(const mjModel& model, int geom);

/// The facets as which MuJoCo draws a geom, in the geom's frame.
///
/// Boxes, planes and meshes are exactly themselves. Round geoms are drawn with `numslices` facets
/// around and `numstacks` from pole to pole (mjVisual.quality), corners on the true surface, so
/// that the drawn solid lies inside the true one by up to 1 - cos(pi / slices) of its radius around
/// and 1 - cos(pi / 2 / stacks) along. (MuJoCo 2.2, render_context.c: the first corner at azimuth
/// 0, rings at equal steps of elevation. Corners there are single precision, 6e-8 off.)
/// @throws SceneError for a height field
std::vector<Triangle> DrawnTriangles(const mjModel& model, int geom);

/// Planes are seen from both sides, closed solids from outside only.
bool IsTwoSided(const mjModel& model, int geom);

/// Unit normal of the true solid at a point of its drawn surface, in the geom's frame: that of the
/// sphere, ellipsoid, cylinder or capsule itself, and of the facet elsewhere.
/// @param facet_normal outward unit normal of the facet that the point is on
Eigen::Vector3d SurfaceNormal(const mjModel& model, int geom, const Eigen::Vector3d& p_G,
                              const Eigen::Vector3d& facet_normal);

}  // namespace horopter::sim
