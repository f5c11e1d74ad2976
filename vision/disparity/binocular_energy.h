// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>

#include "vision/disparity/gabor_bank.h"
#include "vision/disparity/v1_config.h"

namespace horopter::vision {

/// Most phase shifts that a population may have.
inline constexpr int kMaxPhaseShifts = 15;

/// One value for each orientation; those beyond the population's are not used.
using PerOrientation = std::array<float, kMaxOrientations>;

/// The complex cells of one pixel: for each phase shift, the energy of every orientation. What lies
/// d further in the right image along an orientation has a response delayed in phase by 2 pi f0 d;
/// the cell that advances it by as much sees both eyes agree:
///   E = |L + R exp(2 pi i f0 d)| ^ exponent.
class BinocularEnergy {
 public:
  using Energies = std::array<PerOrientation, kMaxPhaseShifts>;

  /// @pre config.Validate() is empty
  explicit BinocularEnergy(const V1Config& config);

  int orientations() const { return orientations_; }
  int phase_shifts() const { return phase_shifts_; }
  /// Disparity along the orientation that the cells of phase shift j prefer [px], rising with j and
  /// symmetric about 0.
  float preferred(int j) const { return preferred_[j]; }

  /// Mean of |L + R exp(..)| below which a pixel is textureless: a multiple of what noise alone
  /// makes, in the units of the cells.
  /// @param octave how many times the image was halved: 0 is full size, 0.5 half an octave above
  float TexturelessEnergy(double octave) const;

  /// Energies without the exponent. Counts above 0 stand for orientations() and phase_shifts(),
  /// which they must equal: loops of known length become vector instructions.
  template <int kOrientationCount, int kShiftCount>
  void Magnitudes(const SimpleCells& left, const SimpleCells& right, Energies& energy) const {
    const int orientations = kOrientationCount > 0 ? kOrientationCount : orientations_;
    const int shifts = kShiftCount > 0 ? kShiftCount : phase_shifts_;
    for (int j = 0; j < shifts; ++j) {
      const float c = cos_phase_[j];
      const float s = sin_phase_[j];
      for (int i = 0; i < orientations; ++i) {
        const float even = left.even[i] + c * right.even[i] - s * right.odd[i];
        const float odd = left.odd[i] + s * right.even[i] + c * right.odd[i];
        energy[j][i] = std::sqrt(even * even + odd * odd);
      }
    }
  }

  /// Raises magnitudes to the exponent. False, and nothing done, where it is 1.
  bool Compress(Energies& energy) const;

 private:
  int orientations_;
  int phase_shifts_;
  float exponent_;
  double noise_energy_;  ///< that counts as texture at full size
  bool normalised_;      ///< the input is, and so noise is the same at every octave
  std::array<float, kMaxPhaseShifts> preferred_{};
  std::array<float, kMaxPhaseShifts> cos_phase_{};
  std::array<float, kMaxPhaseShifts> sin_phase_{};
};

}  // namespace horopter::vision
