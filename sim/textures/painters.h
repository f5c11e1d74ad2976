// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <opencv2/core/matx.hpp>

#include "sim/textures/texture_recipe.h"

namespace horopter::sim {

/// Which face of a box a surface is, by the body axis that it faces. A package's front faces +x.
enum class Side { kFlat, kFront, kBack, kLeft, kRight, kTop, kBottom };

/// The flat surface that one painter covers.
struct Surface {
  double width_m;
  double height_m;
  Side side = Side::kFlat;
  double depth_m = 0;  ///< edge of the box across the surface
};

/// Colour (B, G, R in 0..255, may overshoot) at a point of a surface: x to the right and y down
/// from its upper left corner, in metres. Safe to call from several threads.
using Painter = std::function<cv::Vec3f(double x_m, double y_m)>;

/// The painter of a recipe. Recipes are functions of metres, so that a texture's resolution changes
/// its sharpness only, never what it shows.
/// @pre recipe comes from ParseTextureRecipe
Painter MakePainter(const TextureRecipe& recipe, const Surface& surface, std::uint64_t seed);

}  // namespace horopter::sim
