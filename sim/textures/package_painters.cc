// SPDX-License-Identifier: Apache-2.0
#include "sim/textures/package_painters.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "sim/random/random_stream.h"
#include "sim/textures/print_layout.h"
#include "sim/textures/solid_shapes.h"
#include "sim/textures/tiling_noise.h"

namespace horopter::sim {

namespace {

using cv::Vec3f;

const Vec3f kPaper(222, 236, 240);
const Vec3f kInk(44, 38, 34);

/// The seed of everything on one package, whatever the run's, if the recipe says which print.
std::uint64_t PrintSeed(const TextureRecipe& recipe, std::uint64_t seed) {
  const auto print = recipe.numbers.find("print");
  if (print == recipe.numbers.end()) return seed;
  return MixBits(static_cast<std::uint64_t>(std::llround(print->second * 1000)) + 1);
}

std::string Word(const TextureRecipe& recipe) {
  const auto word = recipe.words.find("word");
  return word == recipe.words.end() ? "BRAND" : word->second;
}

int Motif(const TextureRecipe& recipe) {
  return std::clamp(static_cast<int>(recipe.Number("motif", 0)), 0, 3);
}

struct Palette {
  Vec3f ground;
  Vec3f accent;

  Palette(const TextureRecipe& recipe, std::uint64_t seed) {
    RandomStream random(seed, "palette");
    const double hue = random.Uniform(0, 360), other = hue + random.Uniform(100, 260);
    ground = HueColour(recipe.Number("hue_deg", hue), 0.85f, 178);
    accent = HueColour(recipe.Number("accent_deg", other), 0.9f, 200);
  }
};

Vec3f Mix(const Vec3f& under, const Vec3f& over, float share) {
  return under * (1 - share) + over * share;
}

/// The part of an area between fractions of its width and height.
Rectangle Part(const Rectangle& area, double left, double top, double right, double bottom) {
  return {area.left_m + left * area.width_m(), area.top_m + top * area.height_m(),
          area.left_m + right * area.width_m(), area.top_m + bottom * area.height_m()};
}

/// A heap of what is in a package.
class Heap {
 public:
  Heap(RandomStream& random, const Rectangle& area, int motif) : area_(area), motif_(motif) {
    constexpr int kPieces = 80;
    static const Vec3f kColours[] = {{232, 236, 238}, {176, 214, 228}, {74, 40, 66}, {60, 132, 70}};
    const double unit_m = std::sqrt(area.width_m() * area.height_m() / kPieces);
    const double slender = motif == 1 ? 3.2 : motif == 3 ? 2.2 : 1;
    for (int i = 0; i < kPieces; ++i) {
      Piece piece;
      piece.x_m = random.Uniform(area.left_m, area.right_m);
      piece.y_m = random.Uniform(area.top_m, area.bottom_m);
      const double turn = random.Uniform(0, M_PI);
      piece.cos = std::cos(turn), piece.sin = std::sin(turn);
      piece.length_m = unit_m * random.Uniform(0.55, 0.95) * std::sqrt(slender);
      piece.width_m = piece.length_m / slender;
      piece.colour = kColours[motif] * static_cast<float>(random.Uniform(0.7, 1.05));
      pieces_.push_back(piece);
    }
  }

  const Rectangle& area() const { return area_; }

  /// The uppermost piece there, shaded towards its edge; the ground where there is none.
  Vec3f Colour(double x, double y, const Vec3f& ground) const {
    for (auto piece = pieces_.rbegin(); piece != pieces_.rend(); ++piece) {
      const double dx = x - piece->x_m, dy = y - piece->y_m;
      if (dx * dx + dy * dy > 2 * piece->length_m * piece->length_m) continue;
      const double along = std::abs(dx * piece->cos + dy * piece->sin) / piece->length_m;
      const double across = std::abs(dy * piece->cos - dx * piece->sin) / piece->width_m;
      const double reach = motif_ == 0 ? std::max(along, across) : std::hypot(along, across);
      if (reach < 1) return piece->colour * static_cast<float>(1.05 - 0.5 * reach * reach * reach);
    }
    return ground;
  }

 private:
  struct Piece {
    double x_m, y_m, cos, sin, length_m, width_m;
    Vec3f colour;
  };
  Rectangle area_;
  int motif_;
  std::vector<Piece> pieces_;
};

/// Fibres and the printer's unevenness.
TilingNoise Grain(const Surface& s, std::uint64_t seed) {
  return {seed + 1, s.width_m, s.height_m, {0.3 * std::max(s.width_m, s.height_m), 6, 0.85, 1}};
}

Painter MainPanel(const TextureRecipe& recipe, const Surface& s, std::uint64_t seed) {
  RandomStream random(seed, "front");
  const Palette palette(recipe, seed);
  const Rectangle all{0, 0, s.width_m, s.height_m};
  const Rectangle oval = Part(all, 0.05, 0.13, 0.95, 0.39);
  const Lettering brand(Word(recipe), Part(oval, 0.12, 0.28, 0.88, 0.72));
  const TextBlock slogan(random, Part(all, 0.12, 0.43, 0.88, 0.50), 0.035 * s.height_m);
  const Heap heap(random, Part(all, 0.07, 0.54, 0.93, 0.86), Motif(recipe));
  const TextBlock foot(random, Part(all, 0.07, 0.90, 0.70, 0.97), 0.022 * s.height_m);
  const Lettering weight("1 KG", Part(all, 0.74, 0.905, 0.93, 0.955));
  const TilingNoise grain = Grain(s, seed);
  const double slant = random.Uniform(-0.25, 0.25);
  return [=](double x, double y) {
    const float light = 0.93f + 0.14f * grain.At(x, y);
    const double u = x / s.width_m, v = y / s.height_m;
    Vec3f bgr = palette.ground * static_cast<float>(1.1 - 0.35 * v);
    const double band = v + slant * (u - 0.5);
    if (band < 0.07 || (band > 0.40 && band < 0.42)) bgr = palette.accent;
    const double across = (2 * x - oval.left_m - oval.right_m) / oval.width_m();
    const double down = (2 * y - oval.top_m - oval.bottom_m) / oval.height_m();
    const double reach = std::hypot(across, down);
    if (reach < 1) bgr = reach < 0.9 ? kPaper : palette.accent * 0.7f;
    bgr = Mix(bgr, palette.ground * 0.55f, brand.Ink(x, y));
    if (slogan.Inked(x, y)) bgr = kPaper;
    if (heap.area().Contains(x, y)) bgr = heap.Colour(x, y, palette.ground * 0.45f);
    if (foot.Inked(x, y)) bgr = kPaper * 0.9f;
    bgr = Mix(bgr, kPaper, weight.Ink(x, y));
    return Vec3f(bgr * light);
  };
}

Painter SidePanel(const TextureRecipe& recipe, const Surface& s, std::uint64_t seed) {
  RandomStream random(seed, s.side == Side::kLeft ? "left" : "right");
  const Palette palette(recipe, seed);
  const Rectangle all{0, 0, s.width_m, s.height_m};
  const Lettering brand(Word(recipe), Part(all, 0.12, 0.07, 0.88, 0.15));
  const Rectangle panel = Part(all, 0.09, 0.21, 0.91, 0.72);
  const TextBlock text(random, Part(panel, 0.08, 0.05, 0.92, 0.95), 0.028 * s.height_m);
  const Barcode code(random, Part(all, 0.2, 0.79, 0.8, 0.93));
  const Rectangle code_ground = Part(all, 0.13, 0.77, 0.87, 0.95);
  const TilingNoise grain = Grain(s, seed + 2);
  return [=](double x, double y) {
    const float light = 0.93f + 0.14f * grain.At(x, y);
    Vec3f bgr = palette.ground;
    if (y < 0.035 * s.height_m) bgr = palette.accent;
    bgr = Mix(bgr, kPaper, brand.Ink(x, y));
    if (panel.Contains(x, y) || code_ground.Contains(x, y)) bgr = kPaper;
    if (text.Inked(x, y)) bgr = kInk;
    if (code.area().Contains(x, y) && code.Inked(x)) bgr = kInk;
    return Vec3f(bgr * light);
  };
}

Painter EndPanel(const TextureRecipe& recipe, const Surface& s, std::uint64_t seed) {
  const Palette palette(recipe, seed);
  const Rectangle all{0, 0, s.width_m, s.height_m};
  const Lettering brand(Word(recipe), Part(all, 0.15, 0.38, 0.85, 0.62));
  const TilingNoise grain = Grain(s, seed + 4);
  return [=](double x, double y) {
    const float light = 0.93f + 0.14f * grain.At(x, y);
    const bool flap = std::abs(y / s.height_m - 0.5) > 0.42;
    return Vec3f(Mix(flap ? palette.accent : palette.ground, kPaper, brand.Ink(x, y)) * light);
  };
}

}  // namespace

Painter PackagePainter(const TextureRecipe& recipe, const Surface& surface, std::uint64_t seed) {
  const std::uint64_t print = PrintSeed(recipe, seed);
  switch (surface.side) {
    case Side::kLeft:
    case Side::kRight:
      return SidePanel(recipe, surface, print);
    case Side::kTop:
    case Side::kBottom:
      return EndPanel(recipe, surface, print);
    default:
      return MainPanel(recipe, surface, print);
  }
}

Painter LabelPainter(const TextureRecipe& recipe, const Surface& surface, std::uint64_t seed) {
  const std::uint64_t print = PrintSeed(recipe, seed);
  RandomStream random(print, "label");
  const Palette palette(recipe, print);
  const CylinderSize size = SizeOfCylinder(surface);
  const double r = size.radius_m, h = size.height_m;
  // Everything is printed twice, half a turn apart: brand in front, small print to its left.
  const Lettering brand(Word(recipe), {-0.85 * r, 0.20 * h, 0.85 * r, 0.38 * h});
  const Rectangle panel{-0.42 * r, 0.22 * h, 0.42 * r, 0.84 * h};
  const TextBlock text(random, Part(panel, 0.06, 0.04, 0.94, 0.7), 0.035 * h);
  const Barcode code(random, Part(panel, 0.1, 0.76, 0.9, 0.96));
  const Heap heap(random, {-M_PI / 2 * r, 0.62 * h, M_PI / 2 * r, 0.9 * h}, Motif(recipe));
  const bool metal = recipe.Number("metal", 1) != 0;
  const TilingNoise grain(print + 1, 1, 1, {0.25, 6, 0.85, 1});
  return [=](double x, double y) {
    const CylinderPoint p = OnCylinder(surface, x, y);
    const double turn = p.angle_rad / (2 * M_PI) + 0.5;
    const float light = 0.92f + 0.16f * grain.At(turn, 0.5 * p.down + 0.4 * p.radius);
    const bool rim = p.down < 0.035 || p.down > 0.965;
    if (rim && metal) {
      const bool groove = std::abs(p.radius - 0.82) < 0.04 || std::abs(p.radius - 0.25) < 0.05;
      return Vec3f(Vec3f(196, 198, 200) * (groove ? 0.6f * light : light));
    }
    const double down_m = p.down * h;
    const double front_m = std::remainder(p.angle_rad, M_PI) * r;
    const double side_m = std::remainder(p.angle_rad - M_PI / 2, M_PI) * r;
    Vec3f bgr = palette.ground;
    const double wave = p.down - 0.5 - 0.07 * std::sin(2 * p.angle_rad);
    if (wave > 0.08) bgr = heap.Colour(front_m, down_m, palette.ground * 0.75f);
    if (std::abs(wave) < 0.08) bgr = std::abs(wave) < 0.055 ? palette.accent : kPaper;
    bgr = Mix(bgr, kPaper, brand.Ink(front_m, down_m));
    if (panel.Contains(side_m, down_m)) bgr = kPaper;
    if (text.Inked(side_m, down_m)) bgr = kInk;
    if (code.area().Contains(side_m, down_m) && code.Inked(side_m)) bgr = kInk;
    return Vec3f(bgr * light);
  };
}

Painter CrockeryPainter(const TextureRecipe& recipe, const Surface& surface, std::uint64_t seed) {
  const std::uint64_t print = PrintSeed(recipe, seed);
  RandomStream random(print, "pattern");
  const Palette palette(recipe, print);
  const CylinderSize size = SizeOfCylinder(surface);
  const int around = 7 + static_cast<int>(random.Next() % 3);
  const double pitch_m = 2 * M_PI * size.radius_m / around;
  const double phase = random.Uniform(0, 1);
  const TilingNoise glaze(print + 1, 1, 1, {0.4, 6, 0.85, 1});
  return [=](double x, double y) {
    const CylinderPoint p = OnCylinder(surface, x, y);
    const double turn = p.angle_rad / (2 * M_PI) + 0.5;
    const float light = 0.9f + 0.2f * glaze.At(turn, 0.5 * p.down + 0.4 * p.radius);
    Vec3f bgr(214, 228, 230);
    if ((p.down > 0.06 && p.down < 0.12) || (p.down > 0.86 && p.down < 0.94)) bgr = palette.ground;
    for (int row = 0; row < 3; ++row) {
      const double centre_m = (0.28 + 0.22 * row) * size.height_m;
      const double along = turn * around + phase + 0.5 * row;
      const double dx = (along - std::round(along)) * pitch_m;
      const double reach_m = std::hypot(dx, p.down * size.height_m - centre_m);
      const double dot_m = 0.32 * std::min(pitch_m, 0.22 * size.height_m);
      if (reach_m < dot_m) bgr = row % 2 == 0 ? palette.ground : palette.accent;
      if (reach_m < 0.4 * dot_m) bgr = kPaper;
    }
    return Vec3f(bgr * light);
  };
}

}  // namespace horopter::sim
