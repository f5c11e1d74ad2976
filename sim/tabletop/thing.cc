// SPDX-License-Identifier: Apache-2.0
#include "sim/tabletop/thing.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace horopter::sim {

namespace {

using hardware::Pose;

Pose PoseFrom(const mjtNum position[3], const mjtNum rotation[9]) {
  Pose X = Pose::Identity();
  X.translation() = Eigen::Map<const Eigen::Vector3d>(position);
  X.linear() = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(rotation);
  return X;
}

Eigen::Vector3d HalfEdges(const mjModel& model, int geom) {
  const mjtNum* size = model.geom_size + 3 * geom;
  switch (model.geom_type[geom]) {
    case mjGEOM_SPHERE:
      return Eigen::Vector3d::Constant(size[0]);
    case mjGEOM_CAPSULE:
      return {size[0], size[0], size[0] + size[1]};
    case mjGEOM_CYLINDER:
      return {size[0], size[0], size[1]};
    default:
      return {size[0], size[1], size[2]};
  }
}

void Extend(const World& world, int geom, const Pose& X_BW, Eigen::AlignedBox3d& box) {
  const mjModel& model = world.model();
  const Pose X_BG =
      X_BW * PoseFrom(world.data().geom_xpos + 3 * geom, world.data().geom_xmat + 9 * geom);
  if (model.geom_type[geom] == mjGEOM_MESH) {
    const int mesh = model.geom_dataid[geom];
    const float* vertex = model.mesh_vert + 3 * model.mesh_vertadr[mesh];
    for (int i = 0; i < model.mesh_vertnum[mesh]; ++i, vertex += 3) {
      box.extend(X_BG * Eigen::Vector3d(vertex[0], vertex[1], vertex[2]));
    }
    return;
  }
  const Eigen::Vector3d edges = HalfEdges(model, geom);
  Eigen::Vector3d half = X_BG.linear().cwiseAbs() * edges;
  if (model.geom_type[geom] == mjGEOM_ELLIPSOID) {
    half = (X_BG.linear() * edges.asDiagonal()).rowwise().norm();
  }
  box.extend(X_BG.translation() - half);
  box.extend(X_BG.translation() + half);
}

}  // namespace

Thing::Thing(const World& world, const std::string& body)
    : world_(&world), name_(body), body_(world.Id(mjOBJ_BODY, body)) {
  const Pose X_BW = world.X_WBody(body).inverse();
  for (int geom = 0; geom < world.model().ngeom; ++geom) {
    if (world.model().geom_bodyid[geom] != body_) continue;
    geoms_.push_back(geom);
    Extend(world, geom, X_BW, box_);
  }
  if (geoms_.empty()) throw SceneError(fmt::format("body '{}' has no geoms", body));
}

std::optional<double> Thing::Ray(const Pose& X_WB, const Eigen::Vector3d& p_W,
                                 const Eigen::Vector3d& d_W) const {
  const Eigen::Vector3d to_centre = Centre(X_WB) - p_W;
  if (to_centre.cross(d_W).norm() > radius_m()) return std::nullopt;
  // MuJoCo intersects with the geoms where they are now, so the ray goes there.
  const mjData& data = world_->data();
  const Pose X_NowThen = PoseFrom(data.xpos + 3 * body_, data.xmat + 9 * body_) * X_WB.inverse();
  const Eigen::Vector3d p = X_NowThen * p_W, d = X_NowThen.linear() * d_W;
  double nearest = INFINITY;
  for (const int geom : geoms_) {
    const int type = world_->model().geom_type[geom];
    const double distance =
        type == mjGEOM_MESH
            ? mj_rayMesh(&world_->model(), &data, geom, p.data(), d.data())
            : mju_rayGeom(data.geom_xpos + 3 * geom, data.geom_xmat + 9 * geom,
                          world_->model().geom_size + 3 * geom, p.data(), d.data(), type);
    if (distance >= 0) nearest = std::min(nearest, distance);
  }
  if (std::isinf(nearest)) return std::nullopt;
  return nearest;
}

std::vector<Eigen::Vector2d> GroundPlan::Corners() const {
  const Eigen::Rotation2Dd turn(yaw_rad);
  std::vector<Eigen::Vector2d> corners;
  for (const double sx : {-1.0, 1.0}) {
    for (const double sy : {-1.0, 1.0}) {
      corners.push_back(centre_m + turn * Eigen::Vector2d(sx * half_m.x(), sy * half_m.y()));
    }
  }
  return corners;
}

GroundPlan PlanOf(const Thing& thing, const Pose& X_WB) {
  const double yaw = std::atan2(X_WB(1, 0), X_WB(0, 0));
  return {thing.Centre(X_WB).head<2>(), thing.box().sizes().head<2>() / 2, yaw};
}

bool Apart(const GroundPlan& a, const GroundPlan& b, double gap_m) {
  for (const double yaw : {a.yaw_rad, b.yaw_rad}) {
    for (const double quarter : {0.0, M_PI / 2}) {
      const Eigen::Vector2d axis(std::cos(yaw + quarter), std::sin(yaw + quarter));
      double a_least = INFINITY, a_most = -INFINITY, b_least = INFINITY, b_most = -INFINITY;
      for (const Eigen::Vector2d& corner : a.Corners()) {
        a_least = std::min(a_least, axis.dot(corner)), a_most = std::max(a_most, axis.dot(corner));
      }
      for (const Eigen::Vector2d& corner : b.Corners()) {
        b_least = std::min(b_least, axis.dot(corner)), b_most = std::max(b_most, axis.dot(corner));
      }
      if (b_least - a_most >= gap_m || a_least - b_most >= gap_m) return true;
    }
  }
  return false;
}

}  // namespace horopter::sim
