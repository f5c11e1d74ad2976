// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "hardware/types/time.h"
#include "sim/world/world.h"

namespace horopter::sim {

/// Where everything in a World was at one instant: joint positions, and the poses of bodies, geoms,
/// sites, cameras and lights. Velocities, contacts and the model itself (colours, sizes) are not
/// kept.
class WorldPoses {
 public:
  /// Takes the poses of `world` as they are now. Keeps its memory.
  void Save(const World& world);

  /// Exchanges the world's poses with these, bit by bit. @pre saved from the same world
  void Swap(World& world);

 private:
  std::vector<mjtNum> values_;
};

/// Puts a world back to a past instant for as long as this lives, for looking only: physics must
/// not step meanwhile.
class WorldAt {
 public:
  WorldAt(World& world, WorldPoses& past) : world_(world), past_(past) { past_.Swap(world_); }
  ~WorldAt() { past_.Swap(world_); }
  WorldAt(const WorldAt&) = delete;
  WorldAt& operator=(const WorldAt&) = delete;

 private:
  World& world_;
  WorldPoses& past_;
};

}  // namespace horopter::sim
