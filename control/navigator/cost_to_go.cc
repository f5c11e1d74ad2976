// SPDX-License-Identifier: Apache-2.0
#include "control/navigator/cost_to_go.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <queue>
#include <utility>

namespace horopter::control {

CostToGo::CostToGo(const std::vector<Eigen::Vector2d>& obstacles, const Eigen::Vector2d& start,
                   const Eigen::Vector2d& goal, const CostToGoConfig& config)
    : config_(config) {
  const double beyond_m = std::max(0.0, (goal - start).norm() - config_.reach_m);
  const Eigen::Vector2d nearer_goal = goal - beyond_m * (goal - start).normalized();
  std::vector<Eigen::Vector2d> within;
  std::copy_if(obstacles.begin(), obstacles.end(), std::back_inserter(within),
               [&](const Eigen::Vector2d& p) { return (p - start).norm() <= config_.reach_m; });
  LayOut(start, nearer_goal, within);
  Block(within);
  Spread(CellOf(nearer_goal), beyond_m);
}

void CostToGo::LayOut(const Eigen::Vector2d& start, const Eigen::Vector2d& goal,
                      const std::vector<Eigen::Vector2d>& obstacles) {
  Eigen::Vector2d low = start.cwiseMin(goal), high = start.cwiseMax(goal);
  for (const Eigen::Vector2d& p : obstacles) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  corner_ = low.array() - config_.margin_m;
  const Eigen::Vector2d size = high - low;
  columns_ = static_cast<int>(std::ceil((size.x() + 2 * config_.margin_m) / config_.cell_m));
  rows_ = static_cast<int>(std::ceil((size.y() + 2 * config_.margin_m) / config_.cell_m));
}

double CostToGo::From(const Eigen::Vector2d& p) const {
  Cell cell = CellOf(p);
  if (Contains(cell)) return cost_m_[Index(cell)];
  cell.column = std::clamp(cell.column, 0, columns_ - 1);
  cell.row = std::clamp(cell.row, 0, rows_ - 1);
  return cost_m_[Index(cell)] + (p - CentreOf(cell)).norm();
}

CostToGo::Cell CostToGo::CellOf(const Eigen::Vector2d& p) const {
  const Eigen::Vector2d at = (p - corner_) / config_.cell_m;
  return {static_cast<int>(std::floor(at.x())), static_cast<int>(std::floor(at.y()))};
}

Eigen::Vector2d CostToGo::CentreOf(const Cell& cell) const {
  return corner_ + config_.cell_m * Eigen::Vector2d(cell.column + 0.5, cell.row + 0.5);
}

bool CostToGo::Contains(const Cell& cell) const {
  return cell.column >= 0 && cell.row >= 0 && cell.column < columns_ && cell.row < rows_;
}

std::size_t CostToGo::Index(const Cell& cell) const {
  return static_cast<std::size_t>(cell.row) * columns_ + cell.column;
}

void CostToGo::Block(const std::vector<Eigen::Vector2d>& obstacles) {
  blocked_.assign(static_cast<std::size_t>(columns_) * rows_, 0);
  const int reach = static_cast<int>(std::ceil(config_.clearance_m / config_.cell_m));
  for (const Eigen::Vector2d& p : obstacles) {
    const Cell centre = CellOf(p);
    for (int row = centre.row - reach; row <= centre.row + reach; ++row) {
      for (int column = centre.column - reach; column <= centre.column + reach; ++column) {
        const Cell cell{column, row};
        if (!Contains(cell) || (CentreOf(cell) - p).norm() > config_.clearance_m) continue;
        blocked_[Index(cell)] = 1;
      }
    }
  }
}

void CostToGo::Spread(const Cell& goal, double beyond_m) {
  cost_m_.assign(blocked_.size(), std::numeric_limits<double>::infinity());
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  cost_m_[Index(goal)] = beyond_m;
  open.emplace(beyond_m, Index(goal));
  while (!open.empty()) {
    const auto [cost, index] = open.top();
    open.pop();
    if (cost > cost_m_[index]) continue;
    const Cell at{static_cast<int>(index % columns_), static_cast<int>(index / columns_)};
    for (int dr = -1; dr <= 1; ++dr) {
      for (int dc = -1; dc <= 1; ++dc) {
        const Cell next{at.column + dc, at.row + dr};
        if ((dr == 0 && dc == 0) || !Contains(next)) continue;
        const double step = config_.cell_m * (dr != 0 && dc != 0 ? M_SQRT2 : 1) *
                            (blocked_[Index(next)] != 0 ? config_.blocked_factor : 1);
        if (cost + step >= cost_m_[Index(next)]) continue;
        cost_m_[Index(next)] = cost + step;
        open.emplace(cost + step, Index(next));
      }
    }
  }
}

}  // namespace horopter::control
