// SPDX-License-Identifier: Apache-2.0
#include "sim/rooms/free_path.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>

namespace horopter::sim {
namespace {

using Eigen::Vector2d;

constexpr double kFarthest_m = 1;

/// Cells about a start: the start is the centre of one of them.
class Grid {
 public:
  Grid(const Vector2d& start, const Eigen::AlignedBox2d& floor, double cell_m) : cell_m_(cell_m) {
    const Eigen::Array2d before = ((start - floor.min()).array() / cell_m).floor().max(0);
    origin_ = start - cell_m * before.matrix();
    const Eigen::Array2d fit = ((floor.max() - origin_).array() / cell_m).floor().max(0);
    columns_ = static_cast<int>(fit.x()) + 1;
    rows_ = static_cast<int>(fit.y()) + 1;
  }

  int size() const { return columns_ * rows_; }
  Vector2d Centre(int cell) const {
    return origin_ + cell_m_ * Vector2d(cell % columns_, cell / columns_);
  }
  int Nearest(const Vector2d& p) const {
    const Eigen::Array2d at = ((p - origin_).array() / cell_m_).round();
    const int column = std::clamp(static_cast<int>(at.x()), 0, columns_ - 1);
    const int row = std::clamp(static_cast<int>(at.y()), 0, rows_ - 1);
    return row * columns_ + column;
  }
  /// Calls visit(neighbour, distance in cells) for the up to eight neighbours.
  template <typename Visit>
  void ForNeighbours(int cell, Visit visit) const {
    const int column = cell % columns_, row = cell / columns_;
    for (int dr = -1; dr <= 1; ++dr) {
      for (int dc = -1; dc <= 1; ++dc) {
        if (dr == 0 && dc == 0) continue;
        if (row + dr < 0 || row + dr >= rows_ || column + dc < 0 || column + dc >= columns_)
          continue;
        visit(cell + dr * columns_ + dc, dr != 0 && dc != 0 ? M_SQRT2 : 1.0);
      }
    }
  }

 private:
  double cell_m_;
  Vector2d origin_;
  int columns_ = 0;
  int rows_ = 0;
};

}  // namespace

PathSearch::PathSearch(const CollisionOracle& oracle, int probe_body,
                       const Eigen::AlignedBox2d& floor, double cell_m)
    : oracle_(oracle), probe_body_(probe_body), floor_(floor), cell_m_(cell_m) {}

double PathSearch::ClearanceAt(const Vector2d& p_W) const {
  const hardware::Pose X_WP = hardware::ToPose({p_W.x(), p_W.y(), 0});
  ClearanceOptions options;
  options.max_distance_m = kFarthest_m;
  return oracle_.ClearanceAlong(probe_body_, {&X_WP, 1}, options).nearest.distance_m;
}

std::optional<std::vector<Vector2d>> PathSearch::Find(const Vector2d& start, const Vector2d& goal,
                                                      double clearance_m) const {
  auto path = OverCells(start, goal, clearance_m + cell_m_ * M_SQRT1_2);
  if (!path) return std::nullopt;
  return Shortened(*path, clearance_m);
}

bool PathSearch::Blocked(const Vector2d& start, const Vector2d& goal) const {
  return !OverCells(start, goal, -cell_m_ * M_SQRT1_2).has_value();
}

std::optional<std::vector<Vector2d>> PathSearch::OverCells(const Vector2d& start,
                                                           const Vector2d& goal,
                                                           double at_centres_m) const {
  const Grid grid(start, floor_, cell_m_);
  const int from = grid.Nearest(start), to = grid.Nearest(goal);
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> clearance(grid.size(), kUnknown);
  const auto passable = [&](int cell) {
    if (std::isnan(clearance[cell])) clearance[cell] = ClearanceAt(grid.Centre(cell));
    return clearance[cell] >= at_centres_m;
  };
  std::vector<double> cost(grid.size(), std::numeric_limits<double>::infinity());
  std::vector<int> before(grid.size(), -1);
  const auto left = [&](int cell) { return (grid.Centre(cell) - goal).norm() / cell_m_; };
  using Entry = std::tuple<double, int>;  // cost so far and at least left, cell
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  if (passable(from)) {
    cost[from] = 0;
    open.emplace(left(from), from);
  }
  std::vector<bool> closed(grid.size(), false);
  while (!open.empty() && !closed[to]) {
    const int cell = std::get<1>(open.top());
    open.pop();
    if (closed[cell]) continue;
    closed[cell] = true;
    grid.ForNeighbours(cell, [&](int next, double step) {
      if (closed[next] || cost[cell] + step >= cost[next] || !passable(next)) return;
      cost[next] = cost[cell] + step;
      before[next] = cell;
      open.emplace(cost[next] + left(next), next);
    });
  }
  if (!closed[to]) return std::nullopt;
  std::vector<Vector2d> path{goal};
  for (int cell = to; cell != -1; cell = before[cell]) path.push_back(grid.Centre(cell));
  std::reverse(path.begin(), path.end());
  return path;
}

bool PathSearch::SegmentKeeps(const Vector2d& a, const Vector2d& b, double clearance_m) const {
  constexpr double kLeastSpare_m = 1e-3;
  const double length = (b - a).norm();
  for (double along = 0; along < length;) {
    const double spare = ClearanceAt(a + (b - a) * (along / length)) - clearance_m;
    if (spare < kLeastSpare_m) return false;
    along += spare;
  }
  return ClearanceAt(b) >= clearance_m;
}

std::vector<Vector2d> PathSearch::Shortened(const std::vector<Vector2d>& path,
                                            double clearance_m) const {
  std::vector<Vector2d> corners{path.front()};
  std::size_t at = 0;
  while (at + 1 < path.size()) {
    std::size_t next = at + 1;
    for (std::size_t far = path.size() - 1; far > next; --far) {
      if (SegmentKeeps(path[at], path[far], clearance_m)) next = far;
    }
    if ((path[next] - corners.back()).norm() > 0) corners.push_back(path[next]);
    at = next;
  }
  return corners;
}

double PathSearch::ClearanceAlong(const std::vector<Vector2d>& path) const {
  constexpr double kStep_m = 2e-3;  // so that no place is farther than 1e-3 from a sample
  double least = path.empty() ? kFarthest_m : ClearanceAt(path.front());
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Vector2d way = path[i] - path[i - 1];
    const int steps = std::max(1, static_cast<int>(std::ceil(way.norm() / kStep_m)));
    for (int k = 1; k <= steps; ++k) {
      least = std::min(least, ClearanceAt(path[i - 1] + way * (static_cast<double>(k) / steps)));
    }
  }
  return least;
}

double LengthOf(const std::vector<Vector2d>& path) {
  double length = 0;
  for (std::size_t i = 1; i < path.size(); ++i) length += (path[i] - path[i - 1]).norm();
  return length;
}

}  // namespace horopter::sim
