// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sim/textures/painters.h"

namespace horopter::sim {

/// Recipes of the NAO's workspace: a toy, and the ground outdoors.

/// One face of a die: one to six black pips, by the seed, on an ivory square.
Painter DiePainter(const TextureRecipe& recipe, const Surface& surface, std::uint64_t seed);

/// A lawn, or a clipped hedge: blades in all tones of green, with clumps, dry spots and clover.
Painter GrassPainter(const TextureRecipe& recipe, const Surface& surface, std::uint64_t seed);

}  // namespace horopter::sim
