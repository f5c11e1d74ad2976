// SPDX-License-Identifier: Apache-2.0
#include "sim/textures/painters.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "sim/random/random_stream.h"
#include "sim/textures/fur_painters.h"
#include "sim/textures/package_painters.h"
#include "sim/textures/print_layout.h"
#include "sim/textures/printed_painters.h"
#include "sim/textures/tiling_noise.h"
#include "sim/textures/workspace_painters.h"

namespace horopter::sim {

namespace {

using cv::Vec3f;

/// Uniform in [0, 1) for a cell of a grid: the tone of a brick, of a plank.
float CellTone(std::uint64_t seed, int column, int row) {
  const auto key = static_cast<std::uint64_t>(static_cast<std::uint32_t>(column)) << 32 |
                   static_cast<std::uint32_t>(row);
  return static_cast<float>(MixBits(seed + MixBits(key + 1)) >> 40) * 0x1.0p-24f;
}

/// A running bond: rows of equal height, every other one shifted by half a piece.
struct Bond {
  double length_m;
  double height_m;
  double joint_m;

  struct Hit {
    int column;
    int row;
    bool joint;  ///< between the pieces
  };
  Hit At(double x_m, double y_m) const {
    const double row = std::floor(y_m / height_m);
    const double u = x_m / length_m + (std::fmod(row, 2) != 0 ? 0.5 : 0);
    const double column = std::floor(u);
    const bool joint = (u - column) * length_m < joint_m || y_m - row * height_m < joint_m;
    return {static_cast<int>(column), static_cast<int>(row), joint};
  }
};

Painter Brick(const TextureRecipe& recipe, const Surface& s, std::uint64_t seed) {
  const double course_m = recipe.Number("course_m", 0.075);
  const Bond bond{course_m * 10 / 3, course_m, course_m * 0.14};
  const TilingNoise grain(seed + 1, s.width_m, s.height_m, {0.2, 6, 0.85, 1});
  return [=](double x, double y) {
    const Bond::Hit hit = bond.At(x, y);
    const float light = 0.55f + 0.9f * grain.At(x, y);
    if (hit.joint) return Vec3f(150, 158, 162) * (0.4f + 0.6f * light);
    const float tone = CellTone(seed, hit.column, hit.row);
    return Vec3f(78 + 26 * tone, 100 + 34 * tone, 138 + 42 * tone) * light;
  };
}

Painter Carpet(const TextureRecipe&, const Surface& s, std::uint64_t seed) {
  const TilingNoise pile(seed + 1, s.width_m, s.height_m, {0.65, 8, 0.88, 1});
  const TilingNoise tint(seed + 2, s.width_m, s.height_m, {0.9, 4, 0.7, 1});
  return [=](double x, double y) {
    const float light = std::max(0.1f, 1 + 2.6f * (pile.At(x, y) - 0.5f));
    const float warm = tint.At(x, y) - 0.5f;
    return Vec3f(122 - 30 * warm, 124, 126 + 30 * warm) * light;
  };
}

Painter Curtain(const TextureRecipe& recipe, const Surface& s, std::uint64_t seed) {
  const Vec3f dye = HueColour(recipe.Number("hue_deg", 205), 0.45f, 150);
  const TilingNoise folds(seed + 1, s.width_m, s.height_m, {0.03, 1, 1, 0.03});
  const TilingNoise drape(seed + 2, s.width_m, s.height_m, {0.4, 3, 0.7, 0.15});
  const TilingNoise weave(seed + 3, s.width_m, s.height_m, {0.5, 8, 0.88, 1});
  return [=](double x, double y) {
    const float fold = std::sin(static_cast<float>(2 * M_PI * x / 0.14) + 5 * drape.At(x, y));
    const float light = 1 + 0.28f * fold + 0.3f * (folds.At(x, y) - 0.5f);
    return dye * (light * (0.7f + 0.6f * weave.At(x, y)));
  };
}

Painter Fabric(const TextureRecipe& recipe, const Surface& s, std::uint64_t seed) {
  const float hue = static_cast<float>(recipe.Number("hue_deg", 215) * M_PI / 180);
  const TilingNoise wear(seed + 1, s.width_m, s.height_m, {0.3, 6, 0.85, 1});
  const Vec3f tint(60 * std::cos(hue - 4.19f), 60 * std::cos(hue - 2.09f), 60 * std::cos(hue));
  return [=](double x, double y) {
    const float weave = static_cast<float>(std::sin(x * 420) * std::sin(y * 420));
    return (Vec3f(105, 105, 105) + tint) * (1 + 0.10f * weave + 1.6f * (wear.At(x, y) - 0.5f));
  };
}

Painter Marble(const TextureRecipe&, const Surface& s, std::uint64_t seed) {
  const TilingNoise warp(seed + 1, s.width_m, s.height_m, {0.5, 7, 0.75, 1});
  const TilingNoise cloud(seed + 2, s.width_m, s.height_m, {0.4, 7, 0.8, 1});
  return [=](double x, double y) {
    const float fold = std::sin(28 * warp.At(x, y) + static_cast<float>(4 * x));
    const float vein = std::pow(1 - std::abs(fold), 4.0f);
    const float light = 0.75f + 0.5f * cloud.At(x, y) - 0.55f * vein;
    return Vec3f(205, 206, 210) * light;
  };
}

Painter Parquet(const TextureRecipe& recipe, const Surface& s, std::uint64_t seed) {
  // Whole planks, so that the floor tiles without a seam.
  const double plank_m = recipe.Number("plank_m", 0.09);
  const double rows = std::max(2.0, 2 * std::round(s.height_m / plank_m / 2));
  const double columns = std::max(1.0, std::round(s.width_m / (7 * plank_m)));
  const Bond bond{s.width_m / columns, s.height_m / rows, 0.004};
  const TilingNoise grain(seed + 1, s.width_m, s.height_m, {0.5, 7, 0.85, 7});
  const TilingNoise wear(seed + 2, s.width_m, s.height_m, {0.7, 8, 0.9, 1});
  return [=](double x, double y) {
    const Bond::Hit hit = bond.At(x, y);
    const float tone = CellTone(seed, hit.column % static_cast<int>(columns), hit.row);
    float light =
        0.78f + 0.34f * tone + 0.85f * (grain.At(x, y) - 0.5f) + 1.1f * (wear.At(x, y) - 0.5f);
    if (hit.joint) light *= 0.55f;
    return Vec3f(104, 134, 162) * light;
  };
}

Painter PlainWall(const TextureRecipe&, const Surface& s, std::uint64_t seed) {
  const TilingNoise roller(seed + 1, s.width_m, s.height_m, {0.6, 4, 0.6, 1});
  return [=](double x, double y) {
    return Vec3f(198, 206, 208) * (1 + 0.03f * (roller.At(x, y) - 0.5f));
  };
}

Painter Plaster(const TextureRecipe&, const Surface& s, std::uint64_t seed) {
  const TilingNoise rough(seed + 1, s.width_m, s.height_m, {0.8, 8, 0.9, 1});
  const TilingNoise stains(seed + 2, s.width_m, s.height_m, {1.1, 5, 0.6, 0.6});
  return [=](double x, double y) {
    const float stain = std::max(0.0f, stains.At(x, y) - 0.55f);
    const float light = 1 + 1.3f * (rough.At(x, y) - 0.5f) - 0.9f * stain;
    return Vec3f(158, 172, 178) * light - Vec3f(60, 30, 10) * stain;
  };
}

Painter RedPaint(const TextureRecipe&, const Surface& s, std::uint64_t seed) {
  const TilingNoise shade(seed + 1, s.width_m, s.height_m, {0.25, 6, 0.85, 1});
  const TilingNoise speckle(seed + 2, s.width_m, s.height_m, {0.03, 3, 0.8, 1});
  const TilingNoise scuff(seed + 3, s.width_m, s.height_m, {0.16, 4, 0.7, 6});
  return [=](double x, double y) {
    Vec3f bgr = Vec3f(34, 30, 186) * (1 + 1.1f * (shade.At(x, y) - 0.5f));
    const float dot = speckle.At(x, y);
    if (dot > 0.70f) bgr = bgr * 0.6f + Vec3f(60, 70, 95);
    if (dot < 0.30f) bgr *= 0.5f;
    const float worn = std::clamp((scuff.At(x, y) - 0.68f) * 12, 0.0f, 0.7f);
    return bgr * (1 - worn) + Vec3f(128, 136, 190) * worn;
  };
}

Painter Wood(const TextureRecipe& recipe, const Surface& s, std::uint64_t seed) {
  const float dark = static_cast<float>(recipe.Number("darkness", 0.3));
  const TilingNoise grain(seed + 1, s.width_m, s.height_m, {0.6, 8, 0.85, 9});
  const TilingNoise pores(seed + 2, s.width_m, s.height_m, {0.05, 4, 0.9, 5});
  return [=](double x, double y) {
    const float g = grain.At(x, y);
    const float rings = std::sin(46 * g + static_cast<float>(y) * 3);
    const float light = 1 + 0.9f * (g - 0.5f) + 0.10f * rings + 0.5f * (pores.At(x, y) - 0.5f);
    return Vec3f(72, 112, 164) * ((1 - 0.75f * dark) * light);
  };
}

using Maker = Painter (*)(const TextureRecipe&, const Surface&, std::uint64_t);

const std::map<std::string, Maker>& Makers() {
  static const std::map<std::string, Maker> kMakers = {
      {"books", BooksPainter},
      {"brick", Brick},
      {"cardboard", CardboardPainter},
      {"carpet", Carpet},
      {"chessboard", ChessboardPainter},
      {"crockery", CrockeryPainter},
      {"curtain", Curtain},
      {"die", DiePainter},
      {"fabric", Fabric},
      {"giraffe", GiraffePainter},
      {"label", LabelPainter},
      {"grass", GrassPainter},
      {"marble", Marble},
      {"package", PackagePainter},
      {"paper_print", PaperPrintPainter},
      {"parquet", Parquet},
      {"plain_wall", PlainWall},
      {"plaster", Plaster},
      {"poster", PosterPainter},
      {"red_paint", RedPaint},
      {"tiger", TigerPainter},
      {"wood", Wood},
  };
  return kMakers;
}

}  // namespace

Painter MakePainter(const TextureRecipe& recipe, const Surface& surface, std::uint64_t seed) {
  return Makers().at(recipe.kind)(recipe, surface, seed);
}

}  // namespace horopter::sim
