// SPDX-License-Identifier: Apache-2.0
#include "sim/rooms/room_config.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/rooms/lighting.h"

namespace horopter::sim {

std::vector<hardware::FieldError> RoomConfig::Validate() const {
  constexpr int kMostObstacles = 30;
  constexpr double kMostClearance_m = 2;
  std::vector<hardware::FieldError> errors;
  const auto require = [&errors](bool good, const char* field, std::string value,
                                 std::string constraint) {
    if (!good) errors.push_back({field, std::move(value), std::move(constraint)});
  };
  require(min_obstacles >= 0 && min_obstacles <= kMostObstacles, "room.min_obstacles",
          std::to_string(min_obstacles), fmt::format("must be from 0 to {}", kMostObstacles));
  require(max_obstacles >= min_obstacles && max_obstacles <= kMostObstacles, "room.max_obstacles",
          std::to_string(max_obstacles),
          fmt::format("must be from min_obstacles = {} to {}", min_obstacles, kMostObstacles));
  require(clearance_m > 0 && clearance_m <= kMostClearance_m, "room.clearance_m",
          fmt::format("{:g}", clearance_m), "must be greater than 0 and at most 2 m");
  require(!goals_m.empty(), "room.goals_m", "none", "a path needs at least one goal");
  const bool finite =
      std::isfinite(start_turn_rad) &&
      std::all_of(goals_m.begin(), goals_m.end(), [](auto& goal) { return goal.allFinite(); });
  require(finite, "room.goals_m, start_turn_rad", "not finite", "must be places in the room");
  std::vector<std::string> kinds = LightingNames();
  kinds.insert(kinds.end(), {"varied", "as_built"});
  require(std::find(kinds.begin(), kinds.end(), lighting) != kinds.end(), "room.lighting", lighting,
          fmt::format("must be one of {}", fmt::join(kinds, ", ")));
  return errors;
}

}  // namespace horopter::sim
