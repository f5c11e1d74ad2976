// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

namespace horopter::control {

struct CostToGoConfig {
  double cell_m = 0.05;
  double clearance_m = 0.28;   ///< the robot's centre keeps this far from obstacle points
  double blocked_factor = 20;  ///< by how much a metre within that distance counts more: a goal
                               ///< in a narrow place still has a cost
  double margin_m = 1.5;       ///< how far the grid reaches beyond start, goal and points
  double reach_m = 10;  ///< from the start; further points are left out, and to a further goal the
                        ///< rest of the way counts as straight and free: bounds the grid
};

/// Length of the shortest way to the goal from anywhere near, through what is known: Dijkstra's
/// algorithm over a grid of eight neighbours, from the goal outwards. What has not been seen counts
/// as free.
class CostToGo {
 public:
  /// All in one frame [m]. @param start is covered by the grid too
  CostToGo(const std::vector<Eigen::Vector2d>& obstacles, const Eigen::Vector2d& start,
           const Eigen::Vector2d& goal, const CostToGoConfig& config = {});

  /// [m]; beyond the grid the straight distance from its nearest cell is added.
  double From(const Eigen::Vector2d& p) const;

 private:
  struct Cell {
    int column = 0;
    int row = 0;
  };

  void LayOut(const Eigen::Vector2d& start, const Eigen::Vector2d& goal,
              const std::vector<Eigen::Vector2d>& obstacles);
  Cell CellOf(const Eigen::Vector2d& p) const;
  Eigen::Vector2d CentreOf(const Cell& cell) const;
  bool Contains(const Cell& cell) const;
  std::size_t Index(const Cell& cell) const;
  void Block(const std::vector<Eigen::Vector2d>& obstacles);
  void Spread(const Cell& goal, double beyond_m);

  CostToGoConfig config_;
  Eigen::Vector2d corner_;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<char> blocked_;
  std::vector<double> cost_m_;
};

}  // namespace horopter::control
