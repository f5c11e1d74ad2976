// SPDX-License-Identifier: Apache-2.0
#include "sim/textures/tiling_noise.h"

#include <algorithm>
#include <cmath>

#include "sim/random/random_stream.h"

namespace horopter::sim {

namespace {

/// More lattice points than this along an axis are finer than any texel.
constexpr int kMaxCells = 2048;

int Cells(double extent_m, double cell_m) {
  return std::clamp(static_cast<int>(std::lround(extent_m / cell_m)), 1, kMaxCells);
}

/// Index below, index above and smooth weight of the latter on a ring of `count` points.
struct Span {
  int low;
  int high;
  float weight;
};

Span SpanAt(double position, int count) {
  int low = static_cast<int>(position);
  if (low > position) --low;
  const float t = static_cast<float>(position - low);
  if (low < 0 || low >= count) low = ((low % count) + count) % count;
  return {low, low + 1 == count ? 0 : low + 1, t * t * (3 - 2 * t)};
}

}  // namespace

TilingNoise::TilingNoise(std::uint64_t seed, double width_m, double height_m,
                         const NoiseScale& scale) {
  RandomStream random(seed, "noise");
  double cell_m = scale.coarsest_m;
  double amplitude = 1;
  double sum = 0;
  for (int octave = 0; octave < scale.octaves; ++octave) {
    Lattice lattice;
    lattice.columns = Cells(width_m, cell_m);
    lattice.rows = Cells(height_m, cell_m / scale.stretch);
    lattice.columns_per_m = lattice.columns / width_m;
    lattice.rows_per_m = lattice.rows / height_m;
    lattice.amplitude = static_cast<float>(amplitude);
    lattice.values.resize(static_cast<std::size_t>(lattice.columns) * lattice.rows);
    for (float& value : lattice.values) value = static_cast<float>(random.Uniform(0, 1));
    lattices_.push_back(std::move(lattice));
    sum += amplitude;
    amplitude *= scale.gain;
    cell_m /= 2;
  }
  for (Lattice& lattice : lattices_) lattice.amplitude /= static_cast<float>(sum);
}

float TilingNoise::At(double x_m, double y_m) const {
  float total = 0;
  for (const Lattice& lattice : lattices_) {
    const Span x = SpanAt(x_m * lattice.columns_per_m, lattice.columns);
    const Span y = SpanAt(y_m * lattice.rows_per_m, lattice.rows);
    const float* upper = &lattice.values[static_cast<std::size_t>(y.low) * lattice.columns];
    const float* lower = &lattice.values[static_cast<std::size_t>(y.high) * lattice.columns];
    const float a = upper[x.low] + x.weight * (upper[x.high] - upper[x.low]);
    const float b = lower[x.low] + x.weight * (lower[x.high] - lower[x.low]);
    total += lattice.amplitude * (a + y.weight * (b - a));
  }
  return total;
}

}  // namespace horopter::sim
