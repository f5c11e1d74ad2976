// SPDX-License-Identifier: Apache-2.0
#include "sim/truth/scene_snapshot.h"

#include <utility>

#include "sim/truth/drawn_shape.h"

namespace horopter::sim {
namespace {

using Eigen::Vector3d;
using hardware::Pose;

std::vector<Pose> GeomPoses(const mjModel& model, const mjData& data) {
  std::vector<Pose> poses(static_cast<std::size_t>(model.ngeom), Pose::Identity());
  for (int geom = 0; geom < model.ngeom; ++geom) {
    Pose& X = poses[static_cast<std::size_t>(geom)];
    X.translation() = Eigen::Map<const Vector3d>(data.geom_xpos + 3 * geom);
    X.linear() =
        Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(data.geom_xmat + 9 * geom);
  }
  return poses;
}

std::vector<int> DrawnGeoms(const SceneShapes& shapes) {
  std::vector<int> drawn;
  for (int geom = 0; geom < shapes.geom_count(); ++geom) {
    if (shapes.At(geom) != nullptr) drawn.push_back(geom);
  }
  return drawn;
}

std::vector<Eigen::AlignedBox3d> BoxesInWorld(const SceneShapes& shapes,
                                              const std::vector<Pose>& X_WG,
                                              const std::vector<int>& drawn) {
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const int geom : drawn) {
    const Eigen::AlignedBox3d& box_G = shapes.At(geom)->bounds();
    const Pose& X = X_WG[static_cast<std::size_t>(geom)];
    const Vector3d centre = X * box_G.center();
    const Vector3d reach = X.linear().cwiseAbs() * (box_G.sizes() / 2);
    const Vector3d margin = Vector3d::Constant(1e-9 * (1 + reach.maxCoeff()));
    boxes.emplace_back(centre - reach - margin, centre + reach + margin);
  }
  return boxes;
}

}  // namespace

SceneShapes::SceneShapes(const mjModel& model) : model_(model) {
  facets_.resize(static_cast<std::size_t>(model.ngeom));
  for (int geom = 0; geom < model.ngeom; ++geom) {
    if (!IsDrawn(model, geom)) continue;
    facets_[static_cast<std::size_t>(geom)] =
        std::make_unique<const Facets>(DrawnTriangles(model, geom), IsTwoSided(model, geom));
  }
}

SceneSnapshot::SceneSnapshot(std::shared_ptr<const SceneShapes> shapes, const mjData& data)
    : shapes_(std::move(shapes)),
      X_WG_(GeomPoses(shapes_->model(), data)),
      drawn_(DrawnGeoms(*shapes_)),
      tree_(BoxesInWorld(*shapes_, X_WG_, drawn_), 1) {}

std::optional<SurfaceHit> SceneSnapshot::HitOf(int geom, const Ray& ray_W, double t_min,
                                               double t_max) const {
  const Pose& X = X_WG(geom);
  const Ray ray_G(X.linear().transpose() * (ray_W.origin - X.translation()),
                  X.linear().transpose() * ray_W.direction);
  const auto hit = shapes_->At(geom)->FirstHit(ray_G, t_min, t_max);
  if (!hit) return std::nullopt;
  return SurfaceHit{hit->t, geom, ray_W.origin + hit->t * ray_W.direction,
                    X.linear() * hit->outward_normal};
}

std::optional<SurfaceHit> SceneSnapshot::FirstHit(const Ray& ray_W, double t_min, double t_max,
                                                  int likely_geom) const {
  std::optional<SurfaceHit> first;
  if (likely_geom >= 0) {
    first = HitOf(likely_geom, ray_W, t_min, t_max);
    if (first) t_max = first->t;
  }
  tree_.Traverse(ray_W, t_min, t_max, [&](int item, double t_limit) {
    const int geom = drawn_[static_cast<std::size_t>(item)];
    if (geom == likely_geom) return t_limit;
    const auto hit = HitOf(geom, ray_W, t_min, t_limit);
    // Of surfaces at the same place the first geom is seen, as a depth test passes only what is
    // nearer, and so that the order of search makes no difference.
    if (!hit || (first && hit->t == first->t && geom > first->geom)) return t_limit;
    first = hit;
    return hit->t;
  });
  return first;
}

}  // namespace horopter::sim
