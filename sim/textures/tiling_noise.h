// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace horopter::sim {

/// Which structures a noise has, from coarse to fine.
struct NoiseScale {
  double coarsest_m = 0.5;  ///< size of its largest blotches along x
  int octaves = 6;          ///< each half the size of the one before
  double gain = 0.7;        ///< amplitude of an octave relative to the one before
  double stretch = 1;       ///< blotches are this much longer along x than along y
};

/// Fractal value noise on a surface of a given size, which it tiles without a seam.
///
/// Values of smoothly interpolated random lattices, one per octave, summed. Equal octaves keep
/// contrast at every viewing distance, which is what stereo matching needs.
class TilingNoise {
 public:
  /// @pre width_m, height_m, scale.coarsest_m, scale.stretch > 0; scale.octaves >= 1
  TilingNoise(std::uint64_t seed, double width_m, double height_m, const NoiseScale& scale);

  /// Value in [0, 1] with mean about 0.5, at any point (metres; the surface repeats).
  float At(double x_m, double y_m) const;

 private:
  struct Lattice {
    int columns;
    int rows;
    double columns_per_m;
    double rows_per_m;
    float amplitude;
    std::vector<float> values;
  };
  std::vector<Lattice> lattices_;
};

}  // namespace horopter::sim
