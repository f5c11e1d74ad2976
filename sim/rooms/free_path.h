// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "sim/oracle/collision_oracle.h"

namespace horopter::sim {

/// Searches the floor with a probe: a round body of the oracle's world that no turning about the
/// vertical changes, and whose distance from everything else therefore changes by no more than it
/// is moved.
///
/// That makes both answers proofs, not samples. On a grid of cells of edge a, a cell whose centre
/// keeps clearance + a/sqrt(2) keeps the clearance all over, and on the way to its neighbours; and
/// where a continuous path leads, every cell that it crosses has a centre within a/sqrt(2) of it.
class PathSearch {
 public:
  /// @param probe_body of the oracle's model, upright and symmetric about its origin's vertical
  /// @param floor what is searched, in W [m]; the probe's origin stays within
  /// @param oracle must outlive this; its Sync() poses count
  PathSearch(const CollisionOracle& oracle, int probe_body, const Eigen::AlignedBox2d& floor,
             double cell_m = 0.05);

  /// Distance of the probe at a place from anything that it could hit [m]; negative inside. At most
  /// 1 m is searched.
  double ClearanceAt(const Eigen::Vector2d& p_W) const;

  /// A short path along which the probe keeps `clearance_m`: corners, start and goal among them, in
  /// W [m]. Nothing when the grid has none, which says that there is none that keeps
  /// clearance_m + cell_m * sqrt(2).
  std::optional<std::vector<Eigen::Vector2d>> Find(const Eigen::Vector2d& start,
                                                   const Eigen::Vector2d& goal,
                                                   double clearance_m) const;

  /// Whether no continuous path at all takes the probe from start to goal without touching.
  bool Blocked(const Eigen::Vector2d& start, const Eigen::Vector2d& goal) const;

  /// Smallest clearance of the probe along a line of corners [m], exact to 1e-3.
  double ClearanceAlong(const std::vector<Eigen::Vector2d>& path) const;

 private:
  bool SegmentKeeps(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double clearance_m) const;
  /// Corners that can be cut without losing the clearance are.
  std::vector<Eigen::Vector2d> Shortened(const std::vector<Eigen::Vector2d>& path,
                                         double clearance_m) const;
  /// Shortest way over cells whose centres have at least this clearance.
  std::optional<std::vector<Eigen::Vector2d>> OverCells(const Eigen::Vector2d& start,
                                                        const Eigen::Vector2d& goal,
                                                        double at_centres_m) const;

  const CollisionOracle& oracle_;
  int probe_body_;
  Eigen::AlignedBox2d floor_;
  double cell_m_;
};

/// Length of a line of corners [m].
double LengthOf(const std::vector<Eigen::Vector2d>& path);

}  // namespace horopter::sim
