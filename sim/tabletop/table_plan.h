// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hardware/types/pose.h"
#include "sim/random/random_stream.h"
#include "sim/tabletop/silhouette.h"
#include "sim/tabletop/tabletop_config.h"
#include "sim/tabletop/thing.h"

namespace horopter::sim {

/// A plan of what stands on a table: poses that touch nothing and hide little of each other. Moves
/// nothing in the world.
class TablePlan {
 public:
  /// @param world has the box geom "table_top", level; outlives the plan and keeps its state
  /// @throws SceneError
  TablePlan(const World& world, const TabletopConfig& config, const Eigen::Vector3d& viewpoint_W);

  /// Puts a thing where it stands in the world, whatever is there.
  void Keep(const Thing& thing);
  /// Draws a free place where no object, the thing included, comes to be hidden more than
  /// `max_hidden`. A thing that has a place already is moved.
  /// @param is_object whether it counts when others hide it
  /// @throws SceneError when no place is found
  void Place(const Thing& thing, bool is_object, double max_hidden, RandomStream& random);
  /// Stands `by` in front of the target so that it hides `fraction` of it, and nothing else does.
  /// @throws SceneError when there is no way
  void Occlude(const OcclusionConfig& occlusion, std::uint64_t seed);

  struct Standing {
    Thing thing;
    bool is_object;
    hardware::Pose X_WB;
    Silhouette silhouette;  ///< as the things on the table hide it
  };
  const std::vector<Standing>& standing() const { return standing_; }
  const Standing& Find(const std::string& name) const;
  /// Share of a thing that the others hide from the viewpoint, to about 0.01.
  double Hidden(const std::string& name) const;

  /// Middle of the table's top.
  const Eigen::Vector3d& centre_W() const { return centre_W_; }

 private:
  /// A target as if nothing else were on the table.
  struct Alone {
    const Thing& thing;
    const hardware::Pose& X_WB;
    Silhouette coarse;
    Silhouette fine;
  };
  struct InFront {
    hardware::Pose X_WB;
    std::vector<std::string> in_the_way;
  };

  hardware::Pose Stand(const Thing& thing, const Eigen::Vector2d& at_m, double turned_rad) const;
  bool OnTable(const GroundPlan& plan) const;
  bool Free(const GroundPlan& plan) const;
  bool HidesLittle(const Thing& thing, const hardware::Pose& X_WB, double max_hidden) const;
  std::optional<hardware::Pose> Draw(const Thing& thing, bool is_object, double max_hidden,
                                     RandomStream& random) const;
  void Put(const Thing& thing, bool is_object, const hardware::Pose& X_WB);
  Standing Take(const std::string& name);
  void Refresh();
  std::optional<InFront> FindInFront(const Standing& standing, const Thing& by, double fraction,
                                     double first_side) const;
  std::optional<hardware::Pose> HideAt(const Alone& target, const Thing& by, double fraction,
                                       double nearer_m, double side) const;
  std::vector<std::string> InTheWay(const Alone& target, const Thing& by,
                                    const hardware::Pose& X_WB) const;

  const World& world_;
  TabletopConfig config_;
  Eigen::Vector3d viewpoint_W_;
  Eigen::Vector3d centre_W_;
  Eigen::Vector2d half_m_;  ///< of the area that things stand on
  hardware::Pose X_WTable_;
  std::vector<Standing> standing_;
};

}  // namespace horopter::sim
