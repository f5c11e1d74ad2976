// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/v1_population.h"

#include <algorithm>
#include <cmath>

namespace horopter::vision {

namespace {

// Loops over orientations run over consecutive floats without branches, for the compiler to turn
// into vector instructions; that is also why sums are taken per orientation first.

float Sum(const std::array<float, kOrientations>& v) {
  static_assert(kOrientations == 8);
  return ((v[0] + v[4]) + (v[2] + v[6])) + ((v[1] + v[5]) + (v[3] + v[7]));
}

float Dot(const std::array<float, kOrientations>& a, const std::array<float, kOrientations>& b) {
  std::array<float, kOrientations> products;
  for (int i = 0; i < kOrientations; ++i) products[i] = a[i] * b[i];
  return Sum(products);
}

}  // namespace

Population::Population(const V1Config& config)
    : config_(config),
      threshold_(static_cast<float>(config.response_threshold)),
      subtract_(config.soft_threshold ? threshold_ : 0) {
  for (int j = 0; j < kPhaseShifts; ++j) {
    const double disparity = config.max_disparity_px * (2.0 * j / (kPhaseShifts - 1) - 1);
    const double phase = 2 * M_PI * config.peak_frequency * disparity;
    preferred_[j] = static_cast<float>(disparity);
    cos_phase_[j] = static_cast<float>(std::cos(phase));
    sin_phase_[j] = static_cast<float>(std::sin(phase));
  }
  for (int i = 0; i < kOrientations; ++i) {
    nx_[i] = static_cast<float>(std::cos(OrientationRad(i)));
    ny_[i] = static_cast<float>(std::sin(OrientationRad(i)));
    nx_nx_[i] = nx_[i] * nx_[i];
    nx_ny_[i] = nx_[i] * ny_[i];
    ny_ny_[i] = ny_[i] * ny_[i];
  }
}

float Population::TexturelessEnergy(int octave) const {
  // White noise of deviation s gives each eye's cell a power of s^2 / (4 pi sigma^2), the integral
  // of the squared envelope; the magnitude of two eyes' sum is Rayleigh distributed.
  const double noise = config_.noise_grey / (std::sqrt(8.0) * config_.envelope_sigma_px);
  return static_cast<float>(std::ldexp(config_.min_signal_to_noise * noise, -octave));
}

Constraints Population::Decode(const SimpleCells& left, const SimpleCells& right,
                               float textureless_energy) const {
  const Energies energy = BinocularEnergy(left, right);

  PerOrientation total = {};
  PerOrientation low = energy[0];
  PerOrientation high = energy[0];
  for (const PerOrientation& e : energy) {
    for (int i = 0; i < kOrientations; ++i) {
      total[i] += e[i];
      low[i] = e[i] < low[i] ? e[i] : low[i];
      high[i] = e[i] > high[i] ? e[i] : high[i];
    }
  }
  const float mean = Sum(total) / (kOrientations * kPhaseShifts);
  if (mean < textureless_energy) return {};

  const PerOrientation disparity = CentreOfMass(energy, low, high);

  // Divisive normalisation: response = energy / (c + mean energy of the pixel's population). The
  // centre of mass does not depend on it; which orientations count does.
  const float gain = 1 / (static_cast<float>(config_.saturation_grey) + mean);
  const auto least = static_cast<float>(config_.min_orientation_response);
  PerOrientation counts, weight, pull;
  for (int i = 0; i < kOrientations; ++i) {
    const float response = gain * high[i];
    counts[i] = response >= least ? 1.0F : 0.0F;
    weight[i] = counts[i] * (config_.energy_weights ? response : 1.0F);
    pull[i] = weight[i] * disparity[i];
  }
  Constraints sums;
  sums.nx_nx = Dot(weight, nx_nx_);
  sums.nx_ny = Dot(weight, nx_ny_);
  sums.ny_ny = Dot(weight, ny_ny_);
  sums.nx_d = Dot(pull, nx_);
  sums.ny_d = Dot(pull, ny_);
  sums.count = Sum(counts);
  sums.agreement = 2 * (Dot(left.even, right.even) + Dot(left.odd, right.odd));
  sums.power = Dot(left.even, left.even) + Dot(left.odd, left.odd) + Dot(right.even, right.even) +
               Dot(right.odd, right.odd);
  return sums;
}

Population::Energies Population::BinocularEnergy(const SimpleCells& left,
                                                 const SimpleCells& right) const {
  // What lies d further in the right image has a response delayed in phase by 2 pi f0 d; the cell
  // that advances it by as much sees both eyes agree.
  Energies energy;
  for (int j = 0; j < kPhaseShifts; ++j) {
    const float c = cos_phase_[j];
    const float s = sin_phase_[j];
    for (int i = 0; i < kOrientations; ++i) {
      const float even = left.even[i] + c * right.even[i] - s * right.odd[i];
      const float odd = left.odd[i] + s * right.even[i] + c * right.odd[i];
      energy[j][i] = std::sqrt(even * even + odd * odd);
    }
  }
  return energy;
}

Population::PerOrientation Population::CentreOfMass(const Energies& energy,
                                                    const PerOrientation& low,
                                                    const PerOrientation& high) const {
  PerOrientation scale;
  for (int i = 0; i < kOrientations; ++i) scale[i] = 1 / std::max(high[i] - low[i], 1e-6F);

  PerOrientation mass = {};
  PerOrientation moment = {};
  for (int j = 0; j < kPhaseShifts; ++j) {
    for (int i = 0; i < kOrientations; ++i) {
      const float response = (energy[j][i] - low[i]) * scale[i];
      const float counted = response >= threshold_ ? response - subtract_ : 0.0F;
      mass[i] += counted;
      moment[i] += counted * preferred_[j];
    }
  }
  PerOrientation disparity;
  for (int i = 0; i < kOrientations; ++i) disparity[i] = moment[i] / std::max(mass[i], 1e-6F);
  return disparity;
}

PopulationDisparity Population::Intersect(const Constraints& c) const {
  PopulationDisparity out;
  if (c.count < static_cast<float>(config_.min_orientations)) return out;

  // Eigenvalues l1 <= l2 of the 2x2 matrix: l1 l2 = det, and det / trace^2 grows with l1 / l2.
  const float determinant = c.nx_nx * c.ny_ny - c.nx_ny * c.nx_ny;
  const float trace = c.nx_nx + c.ny_ny;
  const float ratio = static_cast<float>(config_.min_conditioning);
  if (!(determinant * (1 + ratio) * (1 + ratio) >= ratio * trace * trace)) return out;

  out.dx = (c.ny_ny * c.nx_d - c.nx_ny * c.ny_d) / determinant;
  out.dy = (c.nx_nx * c.ny_d - c.nx_ny * c.nx_d) / determinant;
  out.correlation = c.agreement / c.power;
  out.solved = true;
  return out;
}

}  // namespace horopter::vision
