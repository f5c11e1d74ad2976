// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "hardware/types/pose.h"
#include "sim/rooms/obstacle.h"
#include "sim/variation/footprint.h"
#include "sim/world/world.h"

namespace horopter::sim {

/// A disc on the floor.
struct Disc {
  Eigen::Vector2d centre_m = Eigen::Vector2d::Zero();
  double radius_m = 0;
};

/// A piece of furniture, or a part of one.
struct Furniture {
  Footprint footprint;  ///< rectangle along W's axes
  double bottom_m = 0;  ///< above the floor
  double top_m = 0;
};

/// What stands where, seen from above: the furniture's footprints, and discs for all else.
struct FloorPlan {
  Footprint floor;  ///< between the walls
  std::vector<Furniture> furniture;
  std::vector<Disc> discs;  ///< obstacles, and places to be kept free

  /// Whether a disc stands within the floor and this far from everything.
  bool Fits(const Disc& disc, double gap_m) const;
};

/// The plan of a world: its geom "floor", and everything solid that is neither plane nor part of
/// the body `robot` or of one of `others`.
FloorPlan PlanOf(const World& world, int robot, const std::vector<int>& others = {});

/// Where obstacles may be put.
struct Scatter {
  std::vector<Eigen::Vector2d> way;  ///< start and goals: kept free, and the way to stand in
  double keep_out_m = 0;             ///< about each of them, besides the obstacle itself
  bool in_the_way = true;            ///< most stand about the way, the first one right in it
};

/// Gives every obstacle a place and a heading; random.
/// @return false when one of them found none
bool Place(std::vector<Obstacle>& obstacles, FloorPlan plan, const Scatter& scatter,
           std::uint64_t seed, int attempt);

/// A row of screens across the way from start to goal, from wall to wall but for furniture that
/// reaches from the floor to `height_m` and does as well; random.
/// @param index number of the first screen, for its name
/// @return empty when no straight line across the room would do
std::vector<Obstacle> DrawBarrier(const FloorPlan& plan, const Scatter& scatter, double height_m,
                                  int index, std::uint64_t seed, int attempt);

/// Footprint of a placed screen.
Footprint FootprintOf(const Obstacle& screen);

}  // namespace horopter::sim
