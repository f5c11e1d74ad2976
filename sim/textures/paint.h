// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>

#include "sim/textures/painters.h"

namespace horopter::sim {

/// Paints a recipe on a surface: deterministic in (recipe, surface, seed), on any number of
/// threads.
/// @return CV_8UC3 BGR, height_px rows; row 0 is the top
/// @throws hardware::ConfigError when the size is not positive
cv::Mat Paint(const TextureRecipe& recipe, const Surface& surface, std::uint64_t seed, int width_px,
              int height_px);

}  // namespace horopter::sim
