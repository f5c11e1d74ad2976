// SPDX-License-Identifier: Apache-2.0
#include "sim/backend/world_poses.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <span>

namespace horopter::sim {
namespace {

std::array<std::span<mjtNum>, 12> PosesOf(const mjModel& m, const mjData& d) {
  const auto values = [](mjtNum* first, int objects, int each) {
    return std::span<mjtNum>(first, static_cast<std::size_t>(objects) * each);
  };
  return {values(d.qpos, m.nq, 1),           values(d.xpos, m.nbody, 3),
          values(d.xquat, m.nbody, 4),       values(d.xmat, m.nbody, 9),
          values(d.geom_xpos, m.ngeom, 3),   values(d.geom_xmat, m.ngeom, 9),
          values(d.site_xpos, m.nsite, 3),   values(d.site_xmat, m.nsite, 9),
          values(d.cam_xpos, m.ncam, 3),     values(d.cam_xmat, m.ncam, 9),
          values(d.light_xpos, m.nlight, 3), values(d.light_xdir, m.nlight, 3)};
}

}  // namespace

void WorldPoses::Save(const World& world) {
  values_.clear();
  for (const std::span<mjtNum> part : PosesOf(world.model(), world.data())) {
    values_.insert(values_.end(), part.begin(), part.end());
  }
}

void WorldPoses::Swap(World& world) {
  auto mine = values_.begin();
  for (const std::span<mjtNum> part : PosesOf(world.model(), world.mutable_data())) {
    mine = std::swap_ranges(part.begin(), part.end(), mine);
  }
  assert(mine == values_.end());
}

}  // namespace horopter::sim
