// SPDX-License-Identifier: Apache-2.0
#include "sim/oracle/collision_oracle.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sim/oracle/bullet_geometry.h"
#include "sim/oracle/bullet_queries.h"

namespace horopter::sim {

using hardware::Pose;

namespace {

struct Geom {
  int id = -1;
  int body = -1;
  std::string label;
  bool floor = false;
  int contype = 0;
  int conaffinity = 0;
  std::unique_ptr<btConvexShape> shape;  ///< null for a plane
  double plane_half_width_m = 0;         ///< along x, y; 0 = without end
  double plane_half_length_m = 0;
  Pose X_WG = Pose::Identity();

  PlacedShape placed() const { return {shape.get(), ToBullet(X_WG)}; }
  PlacedShape PlacedAt(const Pose& X) const { return {shape.get(), ToBullet(X)}; }
};

bool CanCollide(const Geom& a, const Geom& b) {
  return (a.contype & b.conaffinity) != 0 || (b.contype & a.conaffinity) != 0;
}

Geom MakeGeom(const mjModel& model, int id) {
  Geom geom;
  geom.id = id;
  geom.body = model.geom_bodyid[id];
  geom.label = GeomLabel(model, id);
  geom.contype = model.geom_contype[id];
  geom.conaffinity = model.geom_conaffinity[id];
  geom.shape = MakeConvexShape(model, id);
  if (!geom.shape) {
    geom.plane_half_width_m = model.geom_size[3 * id];
    geom.plane_half_length_m = model.geom_size[3 * id + 1];
  }
  geom.floor = IsFloor(model, id);
  return geom;
}

ClosestPoints ClosestOf(const Geom& a, const Geom& b) {
  if (a.shape && b.shape) return Closest(a.placed(), b.placed());
  if (a.shape) return ClosestToPlane(a.placed(), ToBullet(b.X_WG));
  ClosestPoints closest;
  closest.distance_m = std::numeric_limits<double>::infinity();
  if (b.shape) {
    closest = ClosestToPlane(b.placed(), ToBullet(a.X_WG));
    std::swap(closest.p_WA, closest.p_WB);
    closest.n_BA_W = -closest.n_BA_W;
  }
  return closest;
}

/// As MuJoCo's rays see a plane: its front face, and no farther than its rectangle.
std::optional<RayEntry> CastRayAtPlane(const Geom& plane, const Eigen::Vector3d& from_W,
                                       const Eigen::Vector3d& direction_W, double length_m) {
  const Pose X_PW = plane.X_WG.inverse();
  const Eigen::Vector3d from = X_PW * from_W, direction = X_PW.linear() * direction_W;
  if (from.z() <= 0 || direction.z() >= 0) return std::nullopt;
  const double along = -from.z() / direction.z();
  if (along > length_m) return std::nullopt;
  const Eigen::Vector3d p = from + along * direction;
  const auto within = [](double x, double half) { return half <= 0 || std::abs(x) <= half; };
  if (!within(p.x(), plane.plane_half_width_m) || !within(p.y(), plane.plane_half_length_m)) {
    return std::nullopt;
  }
  return RayEntry{along, ToBullet(Eigen::Vector3d(plane.X_WG.linear().col(2)))};
}

}  // namespace

struct CollisionOracle::Scene {
  std::vector<Geom> geoms;  ///< those that can collide, by ascending id
  std::vector<int> parent;  ///< of each body; the world is its own
  std::vector<Pose> X_WB;   ///< of each body

  const Geom& At(int id) const {
    const auto found =
        std::find_if(geoms.begin(), geoms.end(), [id](const Geom& geom) { return geom.id == id; });
    if (found == geoms.end()) {
      throw std::out_of_range(
          fmt::format("collision oracle: geom {} does not exist or has "
                      "neither contype nor conaffinity",
                      id));
    }
    return *found;
  }

  void RequireBody(int body) const {
    if (body < 0 || body >= static_cast<int>(parent.size())) {
      throw std::out_of_range(
          fmt::format("collision oracle: body {}: there are {}", body, parent.size()));
    }
  }

  bool IsBelow(int body, int root) const {
    while (body != root && body != 0) body = parent[body];
    return body == root;
  }

  /// Lowers `best` where a geom of the robot, moved by X_W'W, is nearer to another; true if so.
  bool Approach(int robot_body, const Pose& X_WnewWold, const ClearanceOptions& options,
                Clearance* best) const;
};

bool CollisionOracle::Scene::Approach(int robot_body, const Pose& X_WnewWold,
                                      const ClearanceOptions& options, Clearance* best) const {
  std::vector<const Geom*> robot, others;
  for (const Geom& geom : geoms) {
    const auto& ignored = options.ignored_geoms;
    if (std::find(ignored.begin(), ignored.end(), geom.id) != ignored.end()) continue;
    if (IsBelow(geom.body, robot_body)) {
      if (geom.shape) robot.push_back(&geom);
    } else if (!geom.floor) {
      others.push_back(&geom);
    }
  }
  bool nearer = false;
  for (const Geom* mine : robot) {
    const PlacedShape mine_placed = mine->PlacedAt(X_WnewWold * mine->X_WG);
    for (const Geom* other : others) {
      if (!CanCollide(*mine, *other)) continue;
      if (other->shape &&
          DistanceAtLeast(mine_placed, other->placed()) > std::max(best->distance_m, 0.0)) {
        continue;
      }
      const ClosestPoints closest = other->shape
                                        ? Closest(mine_placed, other->placed())
                                        : ClosestToPlane(mine_placed, ToBullet(other->X_WG));
      if (closest.distance_m >= best->distance_m) continue;
      *best = {closest.distance_m, mine->label, other->label, FromBullet(closest.p_WA),
               FromBullet(closest.p_WB)};
      nearer = true;
    }
  }
  return nearer;
}

CollisionOracle::CollisionOracle(const mjModel& model) : scene_(std::make_unique<Scene>()) {
  for (int id = 0; id < model.ngeom; ++id) {
    if (model.geom_contype[id] == 0 && model.geom_conaffinity[id] == 0) continue;
    scene_->geoms.push_back(MakeGeom(model, id));
  }
  scene_->parent.assign(model.body_parentid, model.body_parentid + model.nbody);
  scene_->X_WB.assign(model.nbody, Pose::Identity());
}

CollisionOracle::~CollisionOracle() = default;
CollisionOracle::CollisionOracle(CollisionOracle&&) noexcept = default;
CollisionOracle& CollisionOracle::operator=(CollisionOracle&&) noexcept = default;

void CollisionOracle::Sync(const mjData& data) {
  for (Geom& geom : scene_->geoms) {
    geom.X_WG = PoseFromMujoco(data.geom_xpos + 3 * geom.id, data.geom_xmat + 9 * geom.id);
  }
  for (std::size_t body = 0; body < scene_->X_WB.size(); ++body) {
    scene_->X_WB[body] = PoseFromMujoco(data.xpos + 3 * body, data.xmat + 9 * body);
  }
}

double CollisionOracle::Distance(int geom1, int geom2) const {
  return ClosestOf(scene_->At(geom1), scene_->At(geom2)).distance_m;
}

Clearance CollisionOracle::ClearanceOf(int robot_body, const ClearanceOptions& options) const {
  scene_->RequireBody(robot_body);
  Clearance best;
  best.distance_m = options.max_distance_m;
  scene_->Approach(robot_body, Pose::Identity(), options, &best);
  return best;
}

PathClearance CollisionOracle::ClearanceAlong(int robot_body, std::span<const Pose> path,
                                              const ClearanceOptions& options) const {
  scene_->RequireBody(robot_body);
  PathClearance result;
  result.nearest.distance_m = options.max_distance_m;
  const Pose X_BWold = scene_->X_WB[robot_body].inverse();
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (scene_->Approach(robot_body, path[i] * X_BWold, options, &result.nearest)) {
      result.pose_index = i;
    }
  }
  return result;
}

std::optional<RayHit> CollisionOracle::CastRay(const Eigen::Vector3d& from_W,
                                               const Eigen::Vector3d& to_W,
                                               int ignored_body) const {
  if (ignored_body != -1) scene_->RequireBody(ignored_body);
  double length = (to_W - from_W).norm();
  if (!(length > 0) || !std::isfinite(length)) return std::nullopt;
  const Eigen::Vector3d direction_W = (to_W - from_W) / length;
  std::optional<RayHit> first;
  for (const Geom& geom : scene_->geoms) {
    if (ignored_body >= 0 && scene_->IsBelow(geom.body, ignored_body)) continue;
    const std::optional<RayEntry> entry =
        geom.shape ? sim::CastRay(geom.placed(), ToBullet(from_W), ToBullet(direction_W), length)
                   : CastRayAtPlane(geom, from_W, direction_W, length);
    if (!entry || (first && entry->distance_m >= first->distance_m)) continue;
    length = entry->distance_m;
    first = RayHit{length, from_W + length * direction_W, FromBullet(entry->normal_W), geom.id,
                   geom.label};
  }
  return first;
}

}  // namespace horopter::sim
