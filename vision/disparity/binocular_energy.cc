// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/binocular_energy.h"

#include <numbers>

namespace horopter::vision {

BinocularEnergy::BinocularEnergy(const V1Config& config)
    : orientations_(config.orientations),
      phase_shifts_(config.phase_shifts),
      exponent_(static_cast<float>(config.energy_exponent)),
      normalised_(config.normalisation_px > 0) {
  for (int j = 0; j < phase_shifts_; ++j) {
    const double disparity = config.max_disparity_px * (2.0 * j / (phase_shifts_ - 1) - 1);
    const double phase = 2 * M_PI * config.peak_frequency * disparity;
    preferred_[j] = static_cast<float>(disparity);
    cos_phase_[j] = static_cast<float>(std::cos(phase));
    sin_phase_[j] = static_cast<float>(std::sin(phase));
  }
  // White noise of deviation s gives each eye's cell a power of s^2 / (4 pi sigma^2), the integral
  // of the squared envelope; the magnitude of two eyes' sum is Rayleigh distributed. Normalisation
  // over a floor of s makes s / sqrt(2 s^2) of it.
  const double deviation = normalised_ ? 1 / std::numbers::sqrt2 : config.noise_grey;
  const double noise = deviation / (std::sqrt(8.0) * config.envelope_sigma_px);
  noise_energy_ = config.min_signal_to_noise * noise;
}

float BinocularEnergy::TexturelessEnergy(double octave) const {
  return static_cast<float>(normalised_ ? noise_energy_ : noise_energy_ * std::exp2(-octave));
}

bool BinocularEnergy::Compress(Energies& energy) const {
  if (exponent_ == 1) return false;
  for (int j = 0; j < phase_shifts_; ++j) {
    for (int i = 0; i < orientations_; ++i) energy[j][i] = std::pow(energy[j][i], exponent_);
  }
  return true;
}

}  // namespace horopter::vision
