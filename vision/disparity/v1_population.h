// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "vision/disparity/gabor_bank.h"
#include "vision/disparity/v1_config.h"

namespace horopter::vision {

/// What a pixel's orientations say about its disparity vector D: the sums over orientations, each
/// with its direction n, its disparity d along n and its weight w, of the least squares
/// sum w (n.D - d)^2. Sums of several pixels are the constraints of their neighbourhood.
struct Constraints {
  float nx_nx = 0, nx_ny = 0, ny_ny = 0;  ///< sum w n n^T
  float nx_d = 0, ny_d = 0;               ///< sum w n d
  float count = 0;                        ///< orientations that count
  float agreement = 0;                    ///< sum 2 Re(L conj R) over all orientations
  float power = 0;                        ///< sum |L|^2 + |R|^2
};

/// A disparity vector relative to where the right responses were taken.
struct PopulationDisparity {
  float dx = 0;
  float dy = 0;
  /// Binocular correlation of the responses as taken, before the step (dx, dy): 1 for equal images,
  /// about 0 for unrelated ones. It is what the cell tuned to zero disparity sees above chance:
  /// energy^2 / (|L|^2 + |R|^2) - 1.
  float correlation = 0;
  bool solved = false;
};

/// The population of binocular energy neurons of one pixel: kOrientations x kPhaseShifts of them,
/// and how disparity is decoded from it.
class Population {
 public:
  /// @pre config.Validate() is empty
  explicit Population(const V1Config& config);

  /// Mean energy below which a pixel of an octave (0 is full size) is textureless [grey levels].
  float TexturelessEnergy(int octave) const;

  /// Energy, normalisation and centre of mass. A textureless pixel has no constraints.
  /// @param left responses at a pixel
  /// @param right responses where its match is assumed
  Constraints Decode(const SimpleCells& left, const SimpleCells& right,
                     float textureless_energy) const;

  /// Intersection of constraints. Not solved where too few orientations count, or where they leave
  /// one direction open.
  PopulationDisparity Intersect(const Constraints& constraints) const;

 private:
  using PerOrientation = std::array<float, kOrientations>;
  using Energies = std::array<PerOrientation, kPhaseShifts>;

  Energies BinocularEnergy(const SimpleCells& left, const SimpleCells& right) const;
  /// Disparity along each orientation: centre of mass over the phase shifts.
  PerOrientation CentreOfMass(const Energies& energy, const PerOrientation& low,
                              const PerOrientation& high) const;

  V1Config config_;
  float threshold_;
  float subtract_;
  std::array<float, kPhaseShifts> preferred_;  ///< disparity along the orientation [px]
  std::array<float, kPhaseShifts> cos_phase_;
  std::array<float, kPhaseShifts> sin_phase_;
  PerOrientation nx_, ny_;  ///< directions of the orientations
  PerOrientation nx_nx_, nx_ny_, ny_ny_;
};

}  // namespace horopter::vision
