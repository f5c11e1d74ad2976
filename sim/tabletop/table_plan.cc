// SPDX-License-Identifier: Apache-2.0
#include "sim/tabletop/table_plan.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace horopter::sim {

namespace {

using hardware::Pose;

constexpr int kMostDraws = 5000;
constexpr int kCoarseGrid = 28;
constexpr int kFineGrid = 64;

Eigen::Vector2d InDirection(double azimuth_rad) {
  return {std::cos(azimuth_rad), std::sin(azimuth_rad)};
}

}  // namespace

TablePlan::TablePlan(const World& world, const TabletopConfig& config,
                     const Eigen::Vector3d& viewpoint_W)
    : world_(world), config_(config), viewpoint_W_(viewpoint_W) {
  const int top = world.Id(mjOBJ_GEOM, "table_top");
  const mjtNum* half = world.model().geom_size + 3 * top;
  X_WTable_.translation() = Eigen::Map<const Eigen::Vector3d>(world.data().geom_xpos + 3 * top);
  X_WTable_.linear() = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(
      world.data().geom_xmat + 9 * top);
  X_WTable_.makeAffine();
  const bool level = X_WTable_(2, 2) > 1 - 1e-9;
  if (world.model().geom_type[top] != mjGEOM_BOX || !level) {
    throw SceneError("geom 'table_top' must be a level box");
  }
  const ArrangementConfig& area = config.arrangement;
  half_m_ = {std::min(half[0] - area.gap_m, area.depth_m / 2),
             std::min(half[1] - area.gap_m, area.width_m / 2)};
  centre_W_ = X_WTable_ * Eigen::Vector3d(0, 0, half[2]);
}

void TablePlan::Keep(const Thing& thing) { Put(thing, true, world_.X_WBody(thing.name())); }

void TablePlan::Place(const Thing& thing, bool is_object, double max_hidden, RandomStream& random) {
  std::erase_if(standing_, [&](const Standing& s) { return s.thing.name() == thing.name(); });
  Refresh();
  const std::optional<Pose> X_WB = Draw(thing, is_object, max_hidden, random);
  if (!X_WB) {
    throw SceneError(fmt::format(
        "no free place on the table for '{}': put less on it, or lower tabletop.arrangement.gap_m, "
        "or raise max_hidden",
        thing.name()));
  }
  Put(thing, is_object, *X_WB);
}

const TablePlan::Standing& TablePlan::Find(const std::string& name) const {
  const auto found = std::find_if(standing_.begin(), standing_.end(),
                                  [&](const Standing& s) { return s.thing.name() == name; });
  if (found == standing_.end()) throw SceneError(fmt::format("'{}' is not on the table", name));
  return *found;
}

Pose TablePlan::Stand(const Thing& thing, const Eigen::Vector2d& at_m, double turned_rad) const {
  const Eigen::Vector2d to_viewpoint = viewpoint_W_.head<2>() - at_m;
  const double yaw = std::atan2(to_viewpoint.y(), to_viewpoint.x()) + turned_rad;
  Pose X_WB = Pose::Identity();
  X_WB.linear() = Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  X_WB.translation() << at_m, centre_W_.z() - thing.box().min().z();
  return X_WB;
}

bool TablePlan::OnTable(const GroundPlan& plan) const {
  const auto corners = plan.Corners();
  return std::all_of(corners.begin(), corners.end(), [&](const Eigen::Vector2d& corner) {
    const Eigen::Vector3d p = X_WTable_.inverse() * Eigen::Vector3d(corner.x(), corner.y(), 0);
    return std::abs(p.x()) <= half_m_.x() && std::abs(p.y()) <= half_m_.y();
  });
}

bool TablePlan::Free(const GroundPlan& plan) const {
  return std::all_of(standing_.begin(), standing_.end(), [&](const Standing& other) {
    return Apart(plan, PlanOf(other.thing, other.X_WB), config_.arrangement.gap_m);
  });
}

bool TablePlan::HidesLittle(const Thing& thing, const Pose& X_WB, double max_hidden) const {
  return std::all_of(standing_.begin(), standing_.end(), [&](const Standing& other) {
    if (!other.is_object) return true;
    // What is hidden more than that already, as a target may be, must not become more so.
    const double most = std::max(max_hidden, other.silhouette.hidden());
    return other.silhouette.HiddenWith(thing, X_WB) <= most;
  });
}

std::optional<Pose> TablePlan::Draw(const Thing& thing, bool is_object, double max_hidden,
                                    RandomStream& random) const {
  const double spread = config_.arrangement.yaw_spread_rad;
  for (int draw = 0; draw < kMostDraws; ++draw) {
    const Eigen::Vector3d at_Table(half_m_.x() * random.Uniform(-1, 1),
                                   half_m_.y() * random.Uniform(-1, 1), 0);
    const Eigen::Vector2d at_m = (X_WTable_ * at_Table).head<2>();
    const Pose X_WB = Stand(thing, at_m, spread * random.Uniform(-1, 1));
    const GroundPlan plan = PlanOf(thing, X_WB);
    if (!OnTable(plan) || !Free(plan) || !HidesLittle(thing, X_WB, max_hidden)) continue;
    if (is_object) {
      Silhouette own(thing, X_WB, viewpoint_W_, kCoarseGrid);
      for (const Standing& other : standing_) own.Hide(other.thing, other.X_WB);
      if (own.hidden() > max_hidden) continue;
    }
    return X_WB;
  }
  return std::nullopt;
}

void TablePlan::Put(const Thing& thing, bool is_object, const Pose& X_WB) {
  standing_.push_back({thing, is_object, X_WB, {thing, X_WB, viewpoint_W_, kCoarseGrid}});
  Refresh();
}

TablePlan::Standing TablePlan::Take(const std::string& name) {
  Standing taken = Find(name);
  std::erase_if(standing_, [&](const Standing& s) { return s.thing.name() == name; });
  Refresh();
  return taken;
}

double TablePlan::Hidden(const std::string& name) const {
  const Standing& one = Find(name);
  Silhouette fine(one.thing, one.X_WB, viewpoint_W_, kFineGrid);
  for (const Standing& other : standing_) {
    if (other.thing.name() != name) fine.Hide(other.thing, other.X_WB);
  }
  return fine.hidden();
}

void TablePlan::Refresh() {
  for (Standing& one : standing_) {
    one.silhouette = Silhouette(one.thing, one.X_WB, viewpoint_W_, kCoarseGrid);
    for (const Standing& other : standing_) {
      if (&other != &one) one.silhouette.Hide(other.thing, other.X_WB);
    }
  }
}

std::optional<Pose> TablePlan::HideAt(const Alone& target, const Thing& by, double fraction,
                                      double nearer_m, double side) const {
  const Eigen::Vector2d at_m = target.X_WB.translation().head<2>();
  const Eigen::Vector2d to_viewpoint = viewpoint_W_.head<2>() - at_m;
  const double azimuth = std::atan2(to_viewpoint.y(), to_viewpoint.x());
  const auto at = [&](double aside_m) {
    return Stand(
        by,
        at_m + nearer_m * InDirection(azimuth) + side * aside_m * InDirection(azimuth + M_PI / 2),
        0);
  };
  constexpr double kClose = 0.01;
  if (target.coarse.HiddenWith(by, at(0)) < fraction - kClose) return std::nullopt;
  // Straight in front it hides most; moved aside ever less.
  double covers_m = 0, clears_m = target.thing.radius_m() + by.radius_m();
  for (int i = 0; i < 14; ++i) {
    const double middle_m = (covers_m + clears_m) / 2;
    (target.fine.HiddenWith(by, at(middle_m)) >= fraction ? covers_m : clears_m) = middle_m;
  }
  const Pose X_WB = at(covers_m);
  if (std::abs(target.fine.HiddenWith(by, X_WB) - fraction) > kClose) return std::nullopt;
  const GroundPlan plan = PlanOf(by, X_WB);
  const GroundPlan targets = PlanOf(target.thing, target.X_WB);
  if (!OnTable(plan) || !Apart(plan, targets, config_.arrangement.gap_m)) return std::nullopt;
  return X_WB;
}

std::vector<std::string> TablePlan::InTheWay(const Alone& target, const Thing& by,
                                             const Pose& X_WB) const {
  std::vector<std::string> names;
  for (const Standing& other : standing_) {
    if (other.thing.name() == target.thing.name()) continue;
    const double most = std::max(config_.arrangement.max_hidden, other.silhouette.hidden());
    const bool hidden = other.is_object && other.silhouette.HiddenWith(by, X_WB) > most;
    const bool touches =
        !Apart(PlanOf(by, X_WB), PlanOf(other.thing, other.X_WB), config_.arrangement.gap_m);
    const bool hides = target.fine.HiddenWith(other.thing, other.X_WB) > 0;
    if (hidden || touches || hides) names.push_back(other.thing.name());
  }
  return names;
}

std::optional<TablePlan::InFront> TablePlan::FindInFront(const Standing& standing, const Thing& by,
                                                         double fraction, double first_side) const {
  constexpr double kStep_m = 0.015, kFarthest_m = 0.5;
  const Thing& thing = standing.thing;
  const Pose& X_WT = standing.X_WB;
  const Alone target{thing,
                     X_WT,
                     {thing, X_WT, viewpoint_W_, kCoarseGrid},
                     {thing, X_WT, viewpoint_W_, kFineGrid}};
  std::optional<InFront> best;
  for (double nearer_m = 0.05; nearer_m < kFarthest_m; nearer_m += kStep_m) {
    for (const double side : {first_side, -first_side}) {
      const std::optional<Pose> X_WB = HideAt(target, by, fraction, nearer_m, side);
      if (!X_WB) continue;
      InFront there{*X_WB, InTheWay(target, by, *X_WB)};
      if (!best || there.in_the_way.size() < best->in_the_way.size()) best = std::move(there);
      if (best->in_the_way.empty()) return best;
    }
  }
  return best;
}

void TablePlan::Occlude(const OcclusionConfig& occlusion, std::uint64_t seed) {
  constexpr int kMostMoves = 12;
  RandomStream random(seed, "tabletop.occlusion");
  const Thing by = Take(occlusion.by).thing;
  std::optional<InFront> place;
  for (int move = 0; move < kMostMoves && !place; ++move) {
    if (move > 0) {
      const Thing target = Find(occlusion.target).thing;
      Place(target, true, config_.arrangement.max_hidden, random);
    }
    const double first_side = random.Uniform(-1, 1) < 0 ? -1 : 1;
    place = FindInFront(Find(occlusion.target), by, occlusion.fraction, first_side);
  }
  if (!place) {
    throw SceneError(
        fmt::format("'{}' cannot hide {:.0f} % of '{}': take a larger object or a "
                    "smaller fraction",
                    occlusion.by, 100 * occlusion.fraction, occlusion.target));
  }
  std::vector<Standing> evicted;
  for (const std::string& name : place->in_the_way) evicted.push_back(Take(name));
  Put(by, true, place->X_WB);
  for (const Standing& other : evicted) {
    RandomStream elsewhere(seed, "tabletop.occlusion." + other.thing.name());
    const double most =
        other.is_object ? config_.arrangement.max_hidden : config_.clutter.max_hidden;
    Place(other.thing, other.is_object, most, elsewhere);
  }
}

}  // namespace horopter::sim
