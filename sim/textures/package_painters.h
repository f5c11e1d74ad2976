// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sim/textures/painters.h"

namespace horopter::sim {

/// Recipes of household things: what is printed on packages, tins and cups.
///
/// A thing's identity must not change from run to run: with `print` (any number) a recipe ignores
/// the run's seed, and all faces of a box belong to the same package. Colours are `hue_deg` for the
/// ground and `accent_deg` for what stands out (both drawn when not given); `word` is the brand.

/// A food package. The front and back show the brand on an oval, a slogan and a picture of what is
/// in it; the sides a table of contents and a barcode; top and bottom the brand. `motif` is what
/// the picture shows: 0 cubes, 1 grains, 2 berries, 3 leaves.
Painter PackagePainter(const TextureRecipe& recipe, const Surface& surface, std::uint64_t seed);

/// The print around a tin, a can or a bottle: the brand twice, a wave, a picture by `motif`, small
/// print, and lids of bare metal unless `metal=0`.
Painter LabelPainter(const TextureRecipe& recipe, const Surface& surface, std::uint64_t seed);

/// Glazed crockery with bands and rows of dots around it.
Painter CrockeryPainter(const TextureRecipe& recipe, const Surface& surface, std::uint64_t seed);

}  // namespace horopter::sim
