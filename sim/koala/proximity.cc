// SPDX-License-Identifier: Apache-2.0
#include "sim/koala/proximity.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace horopter::sim {

namespace {

constexpr int kFullScale = 1024;

double Range(int sensor) {
  const int from_front = sensor % 8;
  return from_front == 3 || from_front == 6 ? 0.35 : 0.5;
}

}  // namespace

KoalaProximity::KoalaProximity(const World& world) {
  for (int i = 0; i < kKoalaProximityCount; ++i) {
    sites_[i] = world.Id(mjOBJ_SITE, fmt::format("ir_{}", i));
  }
}

std::array<int, kKoalaProximityCount> KoalaProximity::Read(const World& world) const {
  // Group 0 is the room: a sensor does not see the robot that carries it.
  constexpr mjtByte kRoomOnly[mjNGROUP] = {1, 0, 0, 0, 0, 0};
  constexpr int kNoBodyExcluded = -1;
  std::array<int, kKoalaProximityCount> values{};
  for (int i = 0; i < kKoalaProximityCount; ++i) {
    const mjtNum* position = world.data().site_xpos + 3 * sites_[i];
    const mjtNum* axes = world.data().site_xmat + 9 * sites_[i];
    const mjtNum direction[3] = {axes[2], axes[5], axes[8]};
    int geom = -1;
    const double distance_m = mj_ray(&world.model(), &world.data(), position, direction, kRoomOnly,
                                     1, kNoBodyExcluded, &geom);
    if (distance_m < 0) continue;
    const double value = kFullScale * (1 - distance_m / Range(i));
    values[i] = std::clamp(static_cast<int>(std::lround(value)), 0, kFullScale - 1);
  }
  return values;
}

}  // namespace horopter::sim
