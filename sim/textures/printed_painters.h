// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sim/textures/painters.h"

namespace horopter::sim {

/// Recipes whose picture has a layout: things that people print, pack and put on shelves.

/// Rows of book spines on boards; `shelf_m` apart (0.33).
Painter BooksPainter(const TextureRecipe& recipe, const Surface& surface, std::uint64_t seed);

/// Brown corrugated board with a strip of tape, a printed label and scuffs.
Painter CardboardPainter(const TextureRecipe& recipe, const Surface& surface, std::uint64_t seed);

/// Black and white squares of exactly `square_m` (0.04), `squares_x` by `squares_y` (9 by 7),
/// centred on a white surface; the upper left square is black.
Painter ChessboardPainter(const TextureRecipe& recipe, const Surface& surface, std::uint64_t seed);

/// A page of text: headline, lines of words, a figure.
Painter PaperPrintPainter(const TextureRecipe& recipe, const Surface& surface, std::uint64_t seed);

/// Saturated shapes and lettering within a white border.
Painter PosterPainter(const TextureRecipe& recipe, const Surface& surface, std::uint64_t seed);

}  // namespace horopter::sim
