// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

#include "sim/world/world.h"

namespace horopter::sim {

/// Rectangle along W's x and y that contains what it stands for [m].
using Footprint = Eigen::AlignedBox2d;

/// Footprint of a geom that is not a plane, in the world's current state. Exact for boxes,
/// spheres and upright cylinders, otherwise an upper bound.
Footprint FootprintOf(const World& world, int geom);

/// Footprint of a body and everything that rides on it, planes and geoms that touch nothing apart.
/// Empty when nothing is left.
Footprint FootprintOfTree(const World& world, int body);

/// Whether a geom belongs to a body or to something that rides on it.
bool RidesOn(const World& world, int geom, int body);

}  // namespace horopter::sim
