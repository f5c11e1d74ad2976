// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <array>

namespace horopter::sim {

/// Radius of a ball around the geom's position that holds all of it; 0 when not known.
float RadiusOf(const mjvGeom& geom);

/// The pyramid that a camera sees into.
class ViewVolume {
 public:
  /// @param aspect width over height of the image
  ViewVolume(const mjvGLCamera& camera, float aspect);

  /// Whether nothing of the geom can be seen; false when in doubt.
  bool Misses(const mjvGeom& geom) const;

 private:
  struct Plane {
    Eigen::Vector3f outward;  // unit length, in eye axes
    float offset;
  };
  Eigen::Vector3f at_;
  Eigen::Matrix3f eye_from_world_;
  std::array<Plane, 6> planes_;
};

}  // namespace horopter::sim
