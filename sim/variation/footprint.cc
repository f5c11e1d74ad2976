// SPDX-License-Identifier: Apache-2.0
#include "sim/variation/footprint.h"

#include <cmath>

namespace horopter::sim {

namespace {

/// Half edges of the geom's own bounding box.
Eigen::Vector3d HalfEdges(const mjModel& model, int geom) {
  const mjtNum* size = model.geom_size + 3 * geom;
  switch (model.geom_type[geom]) {
    case mjGEOM_BOX:
    case mjGEOM_ELLIPSOID:
      return {size[0], size[1], size[2]};
    case mjGEOM_CYLINDER:
      return {size[0], size[0], size[1]};
    case mjGEOM_CAPSULE:
      return {size[0], size[0], size[0] + size[1]};
    case mjGEOM_SPHERE:
      return Eigen::Vector3d::Constant(size[0]);
    default:
      return Eigen::Vector3d::Constant(model.geom_rbound[geom]);
  }
}

}  // namespace

Footprint FootprintOf(const World& world, int geom) {
  const mjtNum* p = world.data().geom_xpos + 3 * geom;
  const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> R(world.data().geom_xmat +
                                                                         9 * geom);
  const Eigen::Vector3d half = R.cwiseAbs() * HalfEdges(world.model(), geom);
  const Eigen::Vector2d centre(p[0], p[1]);
  return Footprint(centre - half.head<2>(), centre + half.head<2>());
}

bool RidesOn(const World& world, int geom, int body) {
  const mjModel& model = world.model();
  for (int b = model.geom_bodyid[geom]; b != 0; b = model.body_parentid[b]) {
    if (b == body) return true;
  }
  return false;
}

Footprint FootprintOfTree(const World& world, int body) {
  const mjModel& model = world.model();
  Footprint all;
  for (int geom = 0; geom < model.ngeom; ++geom) {
    const bool solid = model.geom_contype[geom] != 0 || model.geom_conaffinity[geom] != 0;
    if (!solid || model.geom_type[geom] == mjGEOM_PLANE || !RidesOn(world, geom, body)) continue;
    all.extend(FootprintOf(world, geom));
  }
  return all;
}

}  // namespace horopter::sim
