// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sim/textures/painters.h"

namespace horopter::sim {

/// Recipes of toy animals: coats in like colours that differ by their pattern alone. They are
/// functions of the place on a solid, so that they wrap ellipsoids without a seam. With `print`
/// they ignore the run's seed; `hue_deg` is the ground's colour (28).

/// Dark stripes around the body's x axis, on orange that pales towards the belly. `stripes` of them
/// (5) from end to end.
Painter TigerPainter(const TextureRecipe& recipe, const Surface& surface, std::uint64_t seed);

/// Brown patches with pale gaps between them, `patches` of them (4) from end to end.
Painter GiraffePainter(const TextureRecipe& recipe, const Surface& surface, std::uint64_t seed);

}  // namespace horopter::sim
