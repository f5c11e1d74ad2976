// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "hardware/types/pose.h"
#include "sim/truth/box_tree.h"
#include "sim/truth/facets.h"

namespace horopter::sim {

/// Every geom that cameras see, in its own frame, as MuJoCo draws it (sim/truth/drawn_shape.h).
class SceneShapes {
 public:
  /// @param model must outlive this; changes to its geoms' shapes afterwards are not seen
  /// @throws SceneError for a visible height field
  explicit SceneShapes(const mjModel& model);

  const mjModel& model() const { return model_; }
  /// Null for a geom that cameras do not see.
  const Facets* At(int geom) const { return facets_[static_cast<std::size_t>(geom)].get(); }
  int geom_count() const { return static_cast<int>(facets_.size()); }

 private:
  const mjModel& model_;
  std::vector<std::unique_ptr<const Facets>> facets_;
};

struct SurfaceHit {
  double t = 0;  ///< in units of the ray's direction
  int geom = -1;
  Eigen::Vector3d p_W;
  Eigen::Vector3d facet_normal_W;  ///< outward unit normal of the drawn facet
};

/// Where every visible surface was at one instant: the geometry that truth is computed from.
///
/// Rays meet what the renderer draws, in double precision: its depth and ids are the renderer's to
/// the precision of its rasteriser, at any point of the image plane and not at pixels alone. Flat
/// geoms agree with mj_ray to 1e-9; round ones lie inside the true solid by what DrawnTriangles()
/// says. A value: it keeps its instant when the world moves on.
class SceneSnapshot {
 public:
  /// @param shapes of the model that `data` belongs to; shared, so that snapshots may outlive the
  ///        one who took them
  /// @param data kinematics up to date (World::Forward)
  SceneSnapshot(std::shared_ptr<const SceneShapes> shapes, const mjData& data);

  const SceneShapes& shapes() const { return *shapes_; }
  const hardware::Pose& X_WG(int geom) const { return X_WG_[static_cast<std::size_t>(geom)]; }

  /// The first surface met in [t_min, t_max].
  /// @param likely_geom tried first, which saves time when it is hit; -1 = none
  std::optional<SurfaceHit> FirstHit(const Ray& ray_W, double t_min, double t_max,
                                     int likely_geom = -1) const;

  /// Where a ray meets one geom, whatever is before it. @pre the geom is drawn
  std::optional<SurfaceHit> HitOf(int geom, const Ray& ray_W, double t_min, double t_max) const;

 private:
  std::shared_ptr<const SceneShapes> shapes_;
  std::vector<hardware::Pose> X_WG_;
  std::vector<int> drawn_;  ///< geoms, in the order of the tree's boxes
  BoxTree tree_;
};

}  // namespace horopter::sim
