// SPDX-License-Identifier: Apache-2.0
#include "sim/textures/fur_painters.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/random/random_stream.h"
#include "sim/textures/print_layout.h"
#include "sim/textures/solid_shapes.h"
#include "sim/textures/tiling_noise.h"

namespace horopter::sim {

namespace {

using cv::Vec3d;
using cv::Vec3f;

std::uint64_t CoatSeed(const TextureRecipe& recipe, std::uint64_t seed) {
  const auto print = recipe.numbers.find("print");
  if (print == recipe.numbers.end()) return seed;
  return MixBits(static_cast<std::uint64_t>(std::llround(print->second * 1000)) + 1);
}

/// Uniform in [0, 1) for a cell of a grid in space.
double CellValue(std::uint64_t seed, std::int64_t i, std::int64_t j, std::int64_t k) {
  const auto bits = [](std::int64_t v) { return static_cast<std::uint64_t>(v); };
  const std::uint64_t mixed =
      MixBits(seed + MixBits(bits(i) + MixBits(bits(j) + MixBits(bits(k) + 1))));
  return static_cast<double>(mixed >> 11) * 0x1.0p-53;
}

/// Smooth noise in space, 0 to 1, with blotches of unit size.
double SpaceNoise(std::uint64_t seed, const Vec3d& p) {
  std::array<std::int64_t, 3> cell;
  std::array<double, 3> t;
  for (int c = 0; c < 3; ++c) {
    cell[c] = static_cast<std::int64_t>(std::floor(p[c]));
    const double f = p[c] - static_cast<double>(cell[c]);
    t[c] = f * f * (3 - 2 * f);
  }
  double value = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const int dx = corner & 1, dy = corner >> 1 & 1, dz = corner >> 2;
    const double weight = (dx ? t[0] : 1 - t[0]) * (dy ? t[1] : 1 - t[1]) * (dz ? t[2] : 1 - t[2]);
    value += weight * CellValue(seed, cell[0] + dx, cell[1] + dy, cell[2] + dz);
  }
  return value;
}

/// Distances to the nearest two of points strewn in space, one per unit cell (Worley 1996), and
/// the tone of the nearest.
struct Patch {
  double nearest = 1e9;
  double second = 1e9;
  double tone = 0;
};

Patch PatchAt(std::uint64_t seed, const Vec3d& p) {
  Patch patch;
  const Vec3d base(std::floor(p[0]), std::floor(p[1]), std::floor(p[2]));
  for (int n = 0; n < 27; ++n) {
    const Vec3d cell = base + Vec3d(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
    const auto i = static_cast<std::int64_t>(cell[0]), j = static_cast<std::int64_t>(cell[1]),
               k = static_cast<std::int64_t>(cell[2]);
    const Vec3d point = cell + Vec3d(CellValue(seed, i, j, k), CellValue(seed + 1, i, j, k),
                                     CellValue(seed + 2, i, j, k));
    const double distance = cv::norm(point - p);
    if (distance < patch.nearest) {
      patch = {distance, patch.nearest, CellValue(seed + 3, i, j, k)};
    } else {
      patch.second = std::min(patch.second, distance);
    }
  }
  return patch;
}

Vec3d OnSphere(const Surface& surface, double x, double y) {
  const Vec3d p = UnitBoxPoint(surface, x, y);
  return p / cv::norm(p);
}

TilingNoise Hair(const Surface& s, std::uint64_t seed) {
  return {seed, s.width_m, s.height_m, {0.4 * std::max(s.width_m, s.height_m), 7, 0.88, 2}};
}

}  // namespace

Painter TigerPainter(const TextureRecipe& recipe, const Surface& s, std::uint64_t run_seed) {
  const std::uint64_t seed = CoatSeed(recipe, run_seed);
  const double stripes = recipe.Number("stripes", 5);
  const Vec3f orange = HueColour(recipe.Number("hue_deg", 28), 0.8f, 214);
  const TilingNoise hair = Hair(s, seed + 9);
  return [=](double x, double y) {
    const Vec3d p = OnSphere(s, x, y);
    const double bend = SpaceNoise(seed, p * 2.2) - 0.5;
    const double breadth = SpaceNoise(seed + 1, p * 3.1);
    const double phase = p[0] * stripes / 2 + 0.9 * bend;
    const float light = 0.8f + 0.4f * hair.At(x, y);
    const bool belly = p[2] < -0.62 + 0.3 * bend;
    if (std::cos(2 * M_PI * phase) > 0.55 - 0.75 * (breadth - 0.4)) {
      if (!belly) return Vec3f(Vec3f(24, 26, 30) * light);
    }
    return Vec3f((belly ? Vec3f(196, 220, 234) : orange) * light);
  };
}

Painter GiraffePainter(const TextureRecipe& recipe, const Surface& s, std::uint64_t run_seed) {
  const std::uint64_t seed = CoatSeed(recipe, run_seed);
  const double patches = recipe.Number("patches", 4);
  const Vec3f ground = HueColour(recipe.Number("hue_deg", 28), 0.55f, 216);
  const TilingNoise hair = Hair(s, seed + 9);
  return [=](double x, double y) {
    const Patch patch = PatchAt(seed, OnSphere(s, x, y) * (patches / 2));
    const float light = 0.8f + 0.4f * hair.At(x, y);
    if (patch.second - patch.nearest < 0.16) return Vec3f(ground * light);
    return Vec3f(Vec3f(36, 74, 128) * static_cast<float>(0.75 + 0.4 * patch.tone) * light);
  };
}

}  // namespace horopter::sim
