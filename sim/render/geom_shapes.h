// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include "sim/render/gl_functions.h"

namespace horopter::sim {

/// Draws the shapes of mjvGeoms with the display lists of an mjrContext, placed and scaled as
/// mjr_render of MuJoCo 2.2.2 does it (read from its OpenGL calls). Colours, lights and textures
/// are the caller's. Both arguments must outlive it.
class GeomShapes {
 public:
  GeomShapes(const GlFunctions& gl, const mjrContext& mujoco) : gl_(gl), mujoco_(mujoco) {}

  /// Whether it is a shape that Draw() knows.
  static bool Knows(const mjvGeom& geom);
  /// Draws it with the modelview matrix as the view.
  /// @param behind shows a plane's back, where GL culls back faces; other shapes ignore it
  void Draw(const mjvGeom& geom, bool behind) const;
  /// The closed unit cylinder and the haze around the horizon, for skies.
  void DrawCylinder() const;
  void DrawHaze() const;

 private:
  void DrawCapsule(const mjvGeom& geom) const;
  void DrawPlane(const mjvGeom& geom, bool behind) const;

  const GlFunctions& gl_;
  const mjrContext& mujoco_;
};

/// Whether `point` lies behind the xy plane of the geom.
bool IsBehind(const mjvGeom& geom, const float point[3]);

}  // namespace horopter::sim
