// SPDX-License-Identifier: Apache-2.0
#include "sim/render/view_volume.h"

#include <algorithm>
#include <cmath>

#include "sim/render/look_along.h"

namespace horopter::sim {

using Eigen::Vector3f;

float RadiusOf(const mjvGeom& geom) {
  if (geom.type != mjGEOM_PLANE) return std::max(geom.modelrbound, 0.f);
  if (geom.size[0] <= 0 || geom.size[1] <= 0) return 0;  // no end
  return std::hypot(geom.size[0], geom.size[1]);
}

ViewVolume::ViewVolume(const mjvGLCamera& camera, float aspect)
    : at_(camera.pos),
      eye_from_world_(LookAlong(camera.pos, camera.forward, camera.up).topLeftCorner<3, 3>()) {
  const float half_width = 0.5f * aspect * (camera.frustum_top - camera.frustum_bottom);
  const float near = camera.frustum_near;
  const float right = (camera.frustum_center + half_width) / near;
  const float left = (camera.frustum_center - half_width) / near;
  const float top = camera.frustum_top / near, bottom = camera.frustum_bottom / near;
  // The eye looks along -z.
  planes_ = {Plane{Vector3f(1, 0, right).normalized(), 0},
             Plane{Vector3f(-1, 0, -left).normalized(), 0},
             Plane{Vector3f(0, 1, top).normalized(), 0},
             Plane{Vector3f(0, -1, -bottom).normalized(), 0},
             Plane{Vector3f(0, 0, 1), -near},
             Plane{Vector3f(0, 0, -1), camera.frustum_far}};
}

bool ViewVolume::Misses(const mjvGeom& geom) const {
  constexpr float kSafety = 1.001f;  // of the radius, for rounding
  constexpr float kSafety_m = 1e-4f;
  const float radius = RadiusOf(geom);
  if (radius <= 0) return false;
  const Vector3f centre = eye_from_world_ * (Vector3f(geom.pos) - at_);
  return std::any_of(planes_.begin(), planes_.end(), [&](const Plane& plane) {
    return plane.outward.dot(centre) - plane.offset > radius * kSafety + kSafety_m;
  });
}

}  // namespace horopter::sim
