// SPDX-License-Identifier: Apache-2.0
#include "sim/textures/printed_painters.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "sim/random/random_stream.h"
#include "sim/textures/print_layout.h"
#include "sim/textures/tiling_noise.h"

namespace horopter::sim {

namespace {

using cv::Vec3f;

struct Book {
  double right_m;
  double top_m;  ///< below the shelf above
  double band_m;
  Vec3f cover;
  Vec3f band;
};

std::vector<Book> FillShelf(RandomStream& random, double width_m, double shelf_m) {
  std::vector<Book> books;
  for (double x = 0.015; x < width_m - 0.02;) {
    Book book;
    x += random.Uniform(0.014, 0.055);
    book.right_m = x;
    book.top_m = shelf_m * random.Uniform(0.12, 0.42);
    book.band_m = random.Uniform(0.03, 0.12);
    book.cover = RandomColour(random, 0.38f);
    book.band = random.Uniform(0, 1) < 0.5 ? Vec3f(190, 205, 210) : RandomColour(random, 0.3f);
    books.push_back(book);
    if (random.Uniform(0, 1) < 0.06) x += random.Uniform(0.02, 0.08);
  }
  return books;
}

struct Shape {
  double x_m;
  double y_m;
  double radius_m;
  bool round;
  Vec3f colour;
};

}  // namespace

Painter BooksPainter(const TextureRecipe& recipe, const Surface& s, std::uint64_t seed) {
  RandomStream random(seed, "layout");
  const int count =
      std::max(1, static_cast<int>(std::lround(s.height_m / recipe.Number("shelf_m", 0.33))));
  const double shelf_m = s.height_m / count;
  std::vector<std::vector<Book>> shelves;
  for (int i = 0; i < count; ++i) shelves.push_back(FillShelf(random, s.width_m, shelf_m));
  const TilingNoise grain(seed + 1, s.width_m, s.height_m, {0.1, 5, 0.85, 1});
  return [=](double x, double y) {
    const float light = 0.7f + 0.6f * grain.At(x, y);
    const int shelf = std::clamp(static_cast<int>(y / shelf_m), 0, count - 1);
    const double depth_m = y - shelf * shelf_m;
    const bool frame = x < 0.015 || x > s.width_m - 0.015 || depth_m > shelf_m - 0.02;
    if (frame) return Vec3f(58, 88, 128) * light;
    const std::vector<Book>& books = shelves[shelf];
    const auto book =
        std::find_if(books.begin(), books.end(), [&](const Book& b) { return x < b.right_m; });
    if (book == books.end() || depth_m < book->top_m) return Vec3f(26, 34, 44) * light;
    const double down_m = depth_m - book->top_m;
    if (book->right_m - x < 0.002) return book->cover * (0.45f * light);
    const bool banded = down_m > book->band_m && down_m < book->band_m + 0.035;
    return (banded ? book->band : book->cover) * light;
  };
}

Painter CardboardPainter(const TextureRecipe&, const Surface& s, std::uint64_t seed) {
  RandomStream random(seed, "layout");
  const double tape_y = s.height_m * random.Uniform(0.4, 0.6);
  const double label_w = s.width_m * random.Uniform(0.25, 0.4);
  const double label_x = random.Uniform(0.05, 0.55) * s.width_m;
  const double label_y = s.height_m * (random.Uniform(0, 1) < 0.5 ? 0.08 : 0.66);
  const Rectangle label{label_x, label_y, label_x + label_w, label_y + 0.24 * s.height_m};
  const Rectangle inner{label.left_m + 0.01, label.top_m + 0.01, label.right_m - 0.01,
                        label.bottom_m - 0.01};
  const TextBlock text(random, inner, 0.014);
  const TilingNoise fibre(seed + 1, s.width_m, s.height_m, {0.25, 7, 0.88, 1});
  const TilingNoise scuff(seed + 2, s.width_m, s.height_m, {0.15, 4, 0.7, 4});
  return [=](double x, double y) {
    const float flute = static_cast<float>(std::sin(x * 2 * M_PI / 0.008));
    const float light = 1 + 1.2f * (fibre.At(x, y) - 0.5f) + 0.03f * flute;
    if (text.Inked(x, y)) return Vec3f(44, 40, 38) * light;
    if (label.Contains(x, y)) return Vec3f(206, 212, 214) * light;
    Vec3f bgr = Vec3f(76, 116, 158) * light;
    if (std::abs(y - tape_y) < 0.025) bgr = bgr * 0.7f + Vec3f(38, 52, 62);
    if (scuff.At(x, y) > 0.72f) bgr *= 1.25f;
    return bgr;
  };
}

Painter ChessboardPainter(const TextureRecipe& recipe, const Surface& s, std::uint64_t) {
  const double square_m = recipe.Number("square_m", 0.04);
  const int squares_x = static_cast<int>(std::lround(recipe.Number("squares_x", 9)));
  const int squares_y = static_cast<int>(std::lround(recipe.Number("squares_y", 7)));
  const double left_m = (s.width_m - squares_x * square_m) / 2;
  const double top_m = (s.height_m - squares_y * square_m) / 2;
  return [=](double x, double y) {
    const double u = std::floor((x - left_m) / square_m);
    const double v = std::floor((y - top_m) / square_m);
    const bool inside = u >= 0 && v >= 0 && u < squares_x && v < squares_y;
    const bool black = inside && std::fmod(u + v, 2) == 0;
    return black ? Vec3f(18, 18, 18) : Vec3f(236, 236, 236);
  };
}

Painter PaperPrintPainter(const TextureRecipe&, const Surface& s, std::uint64_t seed) {
  RandomStream random(seed, "layout");
  const double margin = 0.07 * s.width_m;
  const double line_m = std::clamp(s.height_m / 45, 0.008, 0.03);
  const Rectangle head{margin, margin, s.width_m - margin, margin + 4 * line_m};
  const double figure_y = s.height_m * random.Uniform(0.35, 0.6);
  const Rectangle figure{margin, figure_y, s.width_m * 0.62, figure_y + 0.25 * s.height_m};
  const Rectangle body{margin, head.bottom_m + line_m, s.width_m - margin, s.height_m - margin};
  const TextBlock headline(random, head, 4 * line_m);
  const TextBlock text(random, body, line_m);
  const TilingNoise picture(seed + 1, s.width_m, s.height_m, {0.15, 7, 0.85, 1});
  return [=](double x, double y) {
    const float n = picture.At(x, y);
    if (figure.Contains(x, y))
      return Vec3f(255, 240, 225) * std::clamp(2.5f * n - 0.75f, 0.0f, 1.0f);
    if (headline.Inked(x, y) || text.Inked(x, y)) return Vec3f(40, 34, 32);
    return Vec3f(228, 234, 236) * (0.9f + 0.2f * n);
  };
}

Painter PosterPainter(const TextureRecipe&, const Surface& s, std::uint64_t seed) {
  RandomStream random(seed, "layout");
  const Vec3f upper = RandomColour(random, 0.5f);
  const Vec3f lower = RandomColour(random, 0.5f);
  std::vector<Shape> shapes;
  for (int i = 0; i < 16; ++i) {
    shapes.push_back({random.Uniform(0, s.width_m), random.Uniform(0, 0.75 * s.height_m),
                      s.width_m * random.Uniform(0.03, 0.2), random.Uniform(0, 1) < 0.6,
                      RandomColour(random, 0.6f)});
  }
  const double border = 0.04 * s.width_m;
  const Rectangle picture{border, border, s.width_m - border, s.height_m - border};
  const Rectangle caption{2 * border, 0.8 * s.height_m, s.width_m - 2 * border,
                          s.height_m - 2 * border};
  const TextBlock lettering(random, caption,
                            caption.bottom_m - caption.top_m > 0.16 ? 0.05 : 0.025);
  const TilingNoise grain(seed + 1, s.width_m, s.height_m, {0.12, 6, 0.9, 1});
  return [=](double x, double y) {
    if (!picture.Contains(x, y)) return Vec3f(226, 230, 230);
    const float light = 1 + 1.0f * (grain.At(x, y) - 0.5f);
    if (lettering.Inked(x, y)) return Vec3f(235, 235, 235) * light;
    const float t = static_cast<float>(y / s.height_m);
    Vec3f bgr = upper * (1 - t) + lower * t;
    for (const Shape& shape : shapes) {
      const double dx = std::abs(x - shape.x_m);
      const double dy = std::abs(y - shape.y_m);
      const double reach = shape.round ? std::hypot(dx, dy) : std::max(dx, dy);
      if (reach < shape.radius_m) bgr = shape.colour;
    }
    return bgr * light;
  };
}

}  // namespace horopter::sim
