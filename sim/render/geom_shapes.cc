// SPDX-License-Identifier: Apache-2.0
#include "sim/render/geom_shapes.h"

namespace horopter::sim {
namespace {

// Order of MuJoCo's built-in display lists, from baseBuiltin on (src/render/render_context.h).
enum Builtin : unsigned {
  kSphere,
  kSphereTop,
  kSphereBottom,
  kCylinder,
  kCylinderOpen,
  kHaze,
  kBox,
};

}  // namespace

bool GeomShapes::Knows(const mjvGeom& geom) {
  return geom.type >= mjGEOM_PLANE && geom.type <= mjGEOM_MESH;
}

void GeomShapes::Draw(const mjvGeom& geom, bool behind) const {
  const float* R = geom.mat;
  const float rotation[16] = {R[0], R[3], R[6], 0, R[1], R[4], R[7], 0,
                              R[2], R[5], R[8], 0, 0,    0,    0,    1};
  gl_.PushMatrix();
  gl_.Translatef(geom.pos[0], geom.pos[1], geom.pos[2]);
  gl_.MultMatrixf(rotation);
  const auto scaled = [this, &geom](unsigned list) {
    gl_.Scalef(geom.size[0], geom.size[1], geom.size[2]);
    gl_.CallList(mujoco_.baseBuiltin + list);
  };
  const auto stored = [&geom, this](unsigned base) {
    if (geom.dataid >= 0) gl_.CallList(base + static_cast<unsigned>(geom.dataid));
  };
  switch (geom.type) {
    case mjGEOM_PLANE:
      DrawPlane(geom, behind);
      break;
    case mjGEOM_HFIELD:
      stored(mujoco_.baseHField);
      break;
    case mjGEOM_SPHERE:
    case mjGEOM_ELLIPSOID:
      scaled(kSphere);
      break;
    case mjGEOM_CAPSULE:
      DrawCapsule(geom);
      break;
    case mjGEOM_CYLINDER:
      scaled(kCylinder);
      break;
    case mjGEOM_BOX:
      scaled(kBox);
      break;
    case mjGEOM_MESH:
      stored(mujoco_.baseMesh);
      break;
    default:
      break;
  }
  gl_.PopMatrix();
}

void GeomShapes::DrawPlane(const mjvGeom& geom, bool behind) const {
  if (behind) gl_.CullFace(GL_FRONT);
  if (geom.dataid >= 0) {
    gl_.CallList(mujoco_.basePlane + static_cast<unsigned>(geom.dataid) + 1);
  } else {
    gl_.Scalef(geom.size[0], geom.size[1], 1);
    gl_.CallList(mujoco_.basePlane);
  }
  if (behind) gl_.CullFace(GL_BACK);
}

void GeomShapes::DrawCapsule(const mjvGeom& geom) const {
  // The caps' own lists are unit half spheres that stand on the ends of a cylinder of
  // half-height 1.
  const float radius = 0.5f * (geom.size[0] + geom.size[1]);
  gl_.Scalef(geom.size[0], geom.size[1], geom.size[2]);
  gl_.CallList(mujoco_.baseBuiltin + kCylinderOpen);
  gl_.Scalef(1, 1, radius / geom.size[2]);
  gl_.Translatef(0, 0, (geom.size[2] - radius) / radius);
  gl_.CallList(mujoco_.baseBuiltin + kSphereTop);
  gl_.Translatef(0, 0, 2 * (radius - geom.size[2]) / radius);
  gl_.CallList(mujoco_.baseBuiltin + kSphereBottom);
}

void GeomShapes::DrawCylinder() const { gl_.CallList(mujoco_.baseBuiltin + kCylinder); }
void GeomShapes::DrawHaze() const { gl_.CallList(mujoco_.baseBuiltin + kHaze); }

bool IsBehind(const mjvGeom& geom, const float point[3]) {
  float along = 0;
  for (int k = 0; k < 3; ++k) along += (point[k] - geom.pos[k]) * geom.mat[3 * k + 2];
  return along < 0;
}

}  // namespace horopter::sim
