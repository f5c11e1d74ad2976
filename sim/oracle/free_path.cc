// SPDX-License-Identifier: Apache-2.0
#include "sim/oracle/free_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <queue>
#include <utility>

namespace horopter::sim {
namespace {

using Eigen::Vector2d;
using hardware::FieldError;

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr double kNever = -std::numeric_limits<double>::infinity();

std::string ToText(const Vector2d& p) { return fmt::format("({}, {})", p.x(), p.y()); }

/// Grid points that span the rectangle exactly, then the start and the goal.
class Places {
 public:
  Places(const CollisionOracle& oracle, const PathQuery& query) : oracle_(oracle), query_(query) {
    const Vector2d extent = query.upper_W - query.lower_W;
    for (int axis = 0; axis < 2; ++axis) {
      count_[axis] = 1 + std::max(1, static_cast<int>(std::ceil(extent[axis] / query.step_m)));
      step_[axis] = extent[axis] / (count_[axis] - 1);
    }
    clearance_.assign(static_cast<std::size_t>(goal()) + 1, kUnknown);
  }

  int start() const { return count_[0] * count_[1]; }
  int goal() const { return start() + 1; }
  std::size_t size() const { return clearance_.size(); }
  /// No point of the rectangle is farther than this from its nearest grid point.
  double reach_m() const { return std::hypot(step_[0], step_[1]) / 2; }

  Vector2d At(int place) const {
    if (place == start()) return query_.start_W;
    if (place == goal()) return query_.goal_W;
    return query_.lower_W + Vector2d(place % count_[0] * step_[0], place / count_[0] * step_[1]);
  }

  double Clearance(int place) {
    double& known = clearance_[static_cast<std::size_t>(place)];
    if (std::isnan(known)) {
      known = oracle_.ClearanceOf(query_.robot, At(place), query_.clearance).distance_m;
    }
    return known;
  }

  std::vector<int> Neighbours(int place) const {
    std::vector<int> found;
    if (place >= start()) {
      found.push_back(Nearest(At(place)));
      return found;
    }
    const int i = place % count_[0], j = place / count_[0];
    for (int v = std::max(0, j - 1); v <= std::min(count_[1] - 1, j + 1); ++v) {
      for (int u = std::max(0, i - 1); u <= std::min(count_[0] - 1, i + 1); ++u) {
        if (u != i || v != j) found.push_back(v * count_[0] + u);
      }
    }
    if (Nearest(query_.start_W) == place) found.push_back(start());
    if (Nearest(query_.goal_W) == place) found.push_back(goal());
    return found;
  }

 private:
  int Nearest(const Vector2d& p) const {
    int index[2];
    for (int axis = 0; axis < 2; ++axis) {
      const double along = (p[axis] - query_.lower_W[axis]) / step_[axis];
      index[axis] = std::clamp(static_cast<int>(std::lround(along)), 0, count_[axis] - 1);
    }
    return index[1] * count_[0] + index[0];
  }

  const CollisionOracle& oracle_;
  const PathQuery& query_;
  int count_[2];
  double step_[2];
  std::vector<double> clearance_;
};

struct Bottleneck {
  double width = kNever;
  std::vector<int> places;
};

/// The way from start to goal whose narrowest link is the widest; `width(a, b)` is a link's.
template <typename Width>
Bottleneck Search(const Places& places, Width width) {
  std::vector<double> best(places.size(), kNever);
  std::vector<int> before(places.size(), -1);
  std::priority_queue<std::pair<double, int>> open;
  best[static_cast<std::size_t>(places.start())] = std::numeric_limits<double>::infinity();
  open.emplace(std::numeric_limits<double>::infinity(), places.start());
  while (!open.empty()) {
    const auto [reached, place] = open.top();
    open.pop();
    if (place == places.goal()) break;
    if (reached < best[static_cast<std::size_t>(place)]) continue;
    for (const int next : places.Neighbours(place)) {
      const double through = std::min(reached, width(place, next));
      if (through <= best[static_cast<std::size_t>(next)]) continue;
      best[static_cast<std::size_t>(next)] = through;
      before[static_cast<std::size_t>(next)] = place;
      open.emplace(through, next);
    }
  }
  Bottleneck found{best[static_cast<std::size_t>(places.goal())], {}};
  for (int place = places.goal(); place >= 0; place = before[static_cast<std::size_t>(place)]) {
    found.places.push_back(place);
  }
  std::reverse(found.places.begin(), found.places.end());
  return found;
}

}  // namespace

std::vector<FieldError> PathQuery::Validate() const {
  std::vector<FieldError> errors;
  const auto require = [&errors](bool good, const char* field, std::string value,
                                 const char* rule) {
    if (!good) errors.push_back({field, std::move(value), rule});
  };
  require(robot.radius_m > 0, "path.robot.radius_m", fmt::to_string(robot.radius_m),
          "must be positive");
  require(robot.top_m > robot.bottom_m, "path.robot.top_m", fmt::to_string(robot.top_m),
          "must be above bottom_m");
  require(step_m > 0, "path.step_m", fmt::to_string(step_m), "must be positive");
  const bool spans = (upper_W - lower_W).minCoeff() > 0 && (upper_W - lower_W).allFinite();
  require(spans, "path.upper_W", ToText(upper_W), "must be above and right of lower_W");
  const auto inside = [this](const Vector2d& p) {
    return (p - lower_W).minCoeff() >= 0 && (upper_W - p).minCoeff() >= 0;
  };
  require(inside(start_W), "path.start_W", ToText(start_W), "must lie in the rectangle");
  require(inside(goal_W), "path.goal_W", ToText(goal_W), "must lie in the rectangle");
  return errors;
}

WidestPath FindWidestPath(const CollisionOracle& oracle, const PathQuery& query) {
  hardware::ThrowIfAny(query.Validate());
  Places places(oracle, query);
  // Clearance falls by at most the way gone, from either end of a link.
  const Bottleneck certain = Search(places, [&places](int a, int b) {
    const double length = (places.At(a) - places.At(b)).norm();
    const double ends[] = {places.Clearance(a), places.Clearance(b)};
    return std::min({ends[0], ends[1], (ends[0] + ends[1] - length) / 2});
  });
  // Whatever way there is, the grid points nearest to it are neighbours of each other.
  const Bottleneck possible = Search(places, [&places](int a, int b) {
    const int ends[] = {places.start(), places.goal()};
    double width = std::numeric_limits<double>::infinity();
    for (const int place : {a, b}) {
      const bool exact = std::find(std::begin(ends), std::end(ends), place) != std::end(ends);
      width = std::min(width, places.Clearance(place) + (exact ? 0 : places.reach_m()));
    }
    return width;
  });
  WidestPath path{{}, certain.width, possible.width};
  for (const int place : certain.places) path.points_W.push_back(places.At(place));
  return path;
}

}  // namespace horopter::sim
