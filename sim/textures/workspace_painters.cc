// SPDX-License-Identifier: Apache-2.0
#include "sim/textures/workspace_painters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "sim/random/random_stream.h"
#include "sim/textures/tiling_noise.h"

namespace horopter::sim {

namespace {

using cv::Vec3f;

/// Where the pips of a face are, in thirds of a quarter from the middle.
std::vector<std::pair<int, int>> Pips(int count) {
  std::vector<std::pair<int, int>> pips;
  if (count % 2 == 1) pips.push_back({0, 0});
  if (count >= 2) pips.insert(pips.end(), {{-1, -1}, {1, 1}});
  if (count >= 4) pips.insert(pips.end(), {{-1, 1}, {1, -1}});
  if (count == 6) pips.insert(pips.end(), {{-1, 0}, {1, 0}});
  return pips;
}

}  // namespace

Painter DiePainter(const TextureRecipe&, const Surface& s, std::uint64_t seed) {
  RandomStream random(seed, "pips");
  const auto pips = Pips(1 + static_cast<int>(random.Next() % 6));
  const double edge = std::min(s.width_m, s.height_m);
  const TilingNoise wear(seed + 1, s.width_m, s.height_m, {0.5 * edge, 5, 0.85, 1});
  return [=](double x, double y) {
    const float light = 1 + 0.35f * (wear.At(x, y) - 0.5f);
    for (const auto& [column, row] : pips) {
      const double dx = x - s.width_m / 2 - column * 0.26 * edge;
      const double dy = y - s.height_m / 2 - row * 0.26 * edge;
      if (std::hypot(dx, dy) < 0.095 * edge) return Vec3f(26, 24, 24) * light;
    }
    return Vec3f(206, 224, 230) * light;
  };
}

Painter GrassPainter(const TextureRecipe&, const Surface& s, std::uint64_t seed) {
  const TilingNoise blades(seed + 1, s.width_m, s.height_m, {0.05, 4, 0.9, 0.4});
  const TilingNoise clumps(seed + 2, s.width_m, s.height_m, {0.7, 7, 0.85, 1});
  const TilingNoise dry(seed + 3, s.width_m, s.height_m, {0.5, 5, 0.75, 1});
  const TilingNoise clover(seed + 4, s.width_m, s.height_m, {0.04, 2, 0.6, 1});
  return [=](double x, double y) {
    const float light =
        std::max(0.15f, 1 + 1.5f * (blades.At(x, y) - 0.5f) + 1.7f * (clumps.At(x, y) - 0.5f));
    const float yellow = std::clamp(4 * (dry.At(x, y) - 0.52f), 0.0f, 1.0f);
    Vec3f bgr = Vec3f(48, 128, 92) * (1 - yellow) + Vec3f(74, 142, 148) * yellow;
    if (clover.At(x, y) > 0.84f) bgr = Vec3f(150, 190, 190);
    return bgr * light;
  };
}

}  // namespace horopter::sim
