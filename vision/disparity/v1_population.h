// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "vision/disparity/binocular_energy.h"
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

/// The population of binocular energy neurons of one pixel, orientations x phase shifts of them,
/// and how disparity is decoded from it by centre of mass and intersection of constraints.
class Population {
 public:
  /// @pre config.Validate() is empty
  explicit Population(const V1Config& config);

  float TexturelessEnergy(double octave) const { return energy_.TexturelessEnergy(octave); }

  /// Energy, normalisation and centre of mass. A textureless pixel has no constraints.
  /// @param left responses at a pixel
  /// @param right responses where its match is assumed
  Constraints Decode(const SimpleCells& left, const SimpleCells& right,
                     float textureless_energy) const;

  /// Numbers that a pixel gives to be pooled, and Decode's constraints as such.
  static constexpr int floats() { return sizeof(Constraints) / sizeof(float); }
  void Sense(const SimpleCells& left, const SimpleCells& right, float textureless_energy,
             float* sums) const {
    *reinterpret_cast<Constraints*>(sums) = Decode(left, right, textureless_energy);
  }

  /// Intersection of constraints. Not solved where too few orientations count, or where they leave
  /// one direction open.
  PopulationDisparity Intersect(const Constraints& constraints) const;
  PopulationDisparity Read(const float* pooled) const {
    return Intersect(*reinterpret_cast<const Constraints*>(pooled));
  }

 private:
  using Energies = BinocularEnergy::Energies;

  /// What the cells of a pixel do: their mean, and of each orientation the range over phase shifts.
  struct Activity {
    float mean;
    PerOrientation low, high;
  };

  // Counts as BinocularEnergy::Magnitudes has them.
  template <int kOrientationCount, int kShiftCount>
  Constraints DecodeCounted(const SimpleCells& left, const SimpleCells& right,
                            float textureless_energy) const;
  template <int kOrientationCount, int kShiftCount>
  Activity Survey(const Energies& energy) const;
  /// Disparity along each orientation: centre of mass over the phase shifts.
  template <int kOrientationCount, int kShiftCount>
  PerOrientation CentreOfMass(const Energies& energy, const PerOrientation& low,
                              const PerOrientation& high) const;

  V1Config config_;
  BinocularEnergy energy_;
  float threshold_;
  float subtract_;
  PerOrientation nx_{}, ny_{};  ///< directions of the orientations
  PerOrientation nx_nx_{}, nx_ny_{}, ny_ny_{};
};

}  // namespace horopter::vision
