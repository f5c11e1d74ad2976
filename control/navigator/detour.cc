// SPDX-License-Identifier: Apache-2.0
#include "control/navigator/detour.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "control/navigator/cost_to_go.h"

namespace horopter::control {

std::optional<Detour> ShortestDetour(const KnownGround& known, const Eigen::Vector2d& p_BG,
                                     double distance_m, Strip freer, std::optional<Strip> held,
                                     const NavigatorConfig& config) {
  const double half_width_m = config.strips.corridor_half_width_m;
  const double metres_per_radian =
      config.controller.linear.output_limit / config.controller.angular.output_limit;
  const CostToGo cost_to_go(known.certain_B, {0, 0}, p_BG, {.clearance_m = half_width_m});

  std::optional<Detour> best;
  double best_cost_m = std::numeric_limits<double>::infinity();
  for (int k = 1; k <= config.avoid_directions; ++k) {
    for (const Strip side : {freer, OtherSide(freer)}) {
      const double turn_rad = (side == Strip::kLeft ? k : -k) * config.avoid_angle_rad;
      const double free_m =
          MeasurePoints(known.seen_B, turn_rad, config.strips).near_m(Strip::kCentre);
      const double reach_m =
          std::min(distance_m, free_m - half_width_m - config.waypoint_tolerance_m);
      if (reach_m < config.avoid_min_m) continue;
      const Eigen::Vector2d p_BW =
          reach_m * Eigen::Vector2d(std::cos(turn_rad), std::sin(turn_rad));
      const double cost_m = std::abs(turn_rad) * metres_per_radian + reach_m +
                            cost_to_go.From(p_BW) +
                            (held && side != *held ? config.avoid_other_side_m : 0);
      if (cost_m >= best_cost_m) continue;
      best = Detour{side, turn_rad, reach_m};
      best_cost_m = cost_m;
    }
  }
  return best;
}

}  // namespace horopter::control
