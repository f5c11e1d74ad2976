// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "vision/disparity/binocular_energy.h"
#include "vision/disparity/gabor_bank.h"
#include "vision/disparity/v1_config.h"
#include "vision/disparity/v1_population.h"

namespace horopter::vision {

/// The hierarchy of Chessa & Solari (IJNS 28:1850029, 2018) that decodes disparity from a pixel's
/// complex cells without a threshold and without solving anything:
///
/// 1. Complex cells E(theta, v) of every orientation theta over the full circle and every preferred
///    disparity v; the half circle is enough, since E(theta + pi, v) = E(theta, -v).
/// 2. Divisive normalisation over orientations: N(theta, v) = E(theta, v) / sum over theta of E.
/// 3. Spatial pooling of N with a Gaussian, which the caller does.
/// 4. Cells of area MT for the directions d = 0 and pi / 2:
///    M(d, v) = exp(gain sum over theta of cos(d - theta) N(theta, v)).
/// 5. Linear decoding: dx = sum over v of v M(0, v), dy = sum over v of v M(pi / 2, v).
///
/// The weights of step 4 are linear, as pooling is, and M(d, -v) = 1 / M(d, v): a pair of numbers
/// for each positive v is all that has to be pooled, instead of all cells, and step 5 becomes
/// sum over v > 0 of 2 v sinh(log M).
///
/// The published program scales N to 0.81 of its largest value in the image before step 4, which
/// makes each pixel's disparity depend on the rest of the image. Here the gain is a constant: the
/// one that decodes half of max_disparity_px without bias where all orientations have equal energy,
/// times `readout_gain`.
class LinearReadout {
 public:
  /// @pre config.Validate() is empty
  explicit LinearReadout(const V1Config& config);

  float TexturelessEnergy(double octave) const { return energy_.TexturelessEnergy(octave); }

  /// Numbers that a pixel gives to be pooled.
  int floats() const { return 2 * pairs_ + kOthers; }

  /// Steps 1 and 2, and the sums of step 4. A textureless pixel gives only zeros.
  /// @param left responses at a pixel
  /// @param right responses where its match is assumed
  /// @param sums floats() of them
  void Sense(const SimpleCells& left, const SimpleCells& right, float textureless_energy,
             float* sums) const;

  /// Steps 4 and 5 from sums pooled with weights that add up to 1. Not solved where less than
  /// `min_pooled` of these lie on pixels that gave any; the others stand for all.
  PopulationDisparity Read(const float* pooled) const;

 private:
  /// Of a pixel's sums: whether it gives any, binocular agreement and power, as Constraints do.
  enum { kWeight, kAgreement, kPower, kOthers };

  float Decode(const float* drive, float gain) const;
  /// The gain at which a stimulus with equal energy in all orientations is decoded unbiased.
  float Calibrate(double disparity_px) const;

  BinocularEnergy energy_;
  int pairs_;  ///< preferred disparities above 0
  float min_pooled_;
  float gain_ = 1;
  PerOrientation nx_{}, ny_{};  ///< directions of the orientations
  double peak_frequency_;
};

}  // namespace horopter::vision
