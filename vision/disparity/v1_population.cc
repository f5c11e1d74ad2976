// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/v1_population.h"

#include <algorithm>
#include <cmath>

namespace horopter::vision {

namespace {

// Loops over orientations run over consecutive floats without branches, for the compiler to turn
// into vector instructions; that is also why sums are taken per orientation first.

/// Pairwise: halves are folded onto each other, so that the order is that of vector instructions.
template <int kCount>
float Sum(const PerOrientation& v, int count) {
  if (kCount == 8) return ((v[0] + v[4]) + (v[2] + v[6])) + ((v[1] + v[5]) + (v[3] + v[7]));
  float sum = 0;
  for (int i = 0; i < count; ++i) sum += v[i];
  return sum;
}

template <int kCount>
float Dot(const float* a, const float* b, int count) {
  if (kCount > 0) count = kCount;
  PerOrientation products;
  for (int i = 0; i < count; ++i) products[i] = a[i] * b[i];
  return Sum<kCount>(products, count);
}

}  // namespace

Population::Population(const V1Config& config)
    : config_(config),
      energy_(config),
      threshold_(static_cast<float>(config.response_threshold)),
      subtract_(config.soft_threshold ? threshold_ : 0) {
  for (int i = 0; i < config.orientations; ++i) {
    nx_[i] = static_cast<float>(std::cos(OrientationRad(i, config.orientations)));
    ny_[i] = static_cast<float>(std::sin(OrientationRad(i, config.orientations)));
    nx_nx_[i] = nx_[i] * nx_[i];
    nx_ny_[i] = nx_[i] * ny_[i];
    ny_ny_[i] = ny_[i] * ny_[i];
  }
}

Constraints Population::Decode(const SimpleCells& left, const SimpleCells& right,
                               float textureless_energy) const {
  const bool as_of_2009 = config_.orientations == kOrientations &&
                          config_.phase_shifts == kPhaseShifts && config_.energy_exponent == 1;
  if (as_of_2009) {
    return DecodeCounted<kOrientations, kPhaseShifts>(left, right, textureless_energy);
  }
  return DecodeCounted<0, 0>(left, right, textureless_energy);
}

template <int kOrientationCount, int kShiftCount>
Constraints Population::DecodeCounted(const SimpleCells& left, const SimpleCells& right,
                                      float textureless_energy) const {
  const int n = kOrientationCount > 0 ? kOrientationCount : config_.orientations;
  Energies energy;
  energy_.Magnitudes<kOrientationCount, kShiftCount>(left, right, energy);

  Activity activity = Survey<kOrientationCount, kShiftCount>(energy);
  if (activity.mean < textureless_energy) return {};
  if constexpr (kOrientationCount == 0) {  // fixed counts are for energies without an exponent
    if (energy_.Compress(energy)) activity = Survey<kOrientationCount, kShiftCount>(energy);
  }
  const PerOrientation disparity =
      CentreOfMass<kOrientationCount, kShiftCount>(energy, activity.low, activity.high);

  // Divisive normalisation: response = energy / (c + mean energy of the pixel's population). The
  // centre of mass does not depend on it; which orientations count does.
  const float gain = 1 / (static_cast<float>(config_.saturation_grey) + activity.mean);
  const auto least = static_cast<float>(config_.min_orientation_response);
  PerOrientation counts, weight, pull;
  for (int i = 0; i < n; ++i) {
    const float response = gain * activity.high[i];
    counts[i] = response >= least ? 1.0F : 0.0F;
    weight[i] = counts[i] * (config_.energy_weights ? response : 1.0F);
    pull[i] = weight[i] * disparity[i];
  }
  const auto dot = [n](const float* a, const float* b) { return Dot<kOrientationCount>(a, b, n); };
  Constraints sums;
  sums.nx_nx = dot(weight.data(), nx_nx_.data());
  sums.nx_ny = dot(weight.data(), nx_ny_.data());
  sums.ny_ny = dot(weight.data(), ny_ny_.data());
  sums.nx_d = dot(pull.data(), nx_.data());
  sums.ny_d = dot(pull.data(), ny_.data());
  sums.count = Sum<kOrientationCount>(counts, n);
  sums.agreement = 2 * (dot(left.even, right.even) + dot(left.odd, right.odd));
  sums.power = dot(left.even, left.even) + dot(left.odd, left.odd) + dot(right.even, right.even) +
               dot(right.odd, right.odd);
  return sums;
}

template <int kOrientationCount, int kShiftCount>
Population::Activity Population::Survey(const Energies& energy) const {
  const int n = kOrientationCount > 0 ? kOrientationCount : config_.orientations;
  const int shifts = kShiftCount > 0 ? kShiftCount : config_.phase_shifts;
  PerOrientation total = {};
  Activity activity;
  for (int i = 0; i < n; ++i) activity.low[i] = activity.high[i] = energy[0][i];
  for (int j = 0; j < shifts; ++j) {
    const PerOrientation& e = energy[j];
    for (int i = 0; i < n; ++i) {
      total[i] += e[i];
      activity.low[i] = e[i] < activity.low[i] ? e[i] : activity.low[i];
      activity.high[i] = e[i] > activity.high[i] ? e[i] : activity.high[i];
    }
  }
  activity.mean = Sum<kOrientationCount>(total, n) / static_cast<float>(n * shifts);
  return activity;
}

template <int kOrientationCount, int kShiftCount>
PerOrientation Population::CentreOfMass(const Energies& energy, const PerOrientation& low,
                                        const PerOrientation& high) const {
  const int n = kOrientationCount > 0 ? kOrientationCount : config_.orientations;
  const int shifts = kShiftCount > 0 ? kShiftCount : config_.phase_shifts;
  PerOrientation scale;
  for (int i = 0; i < n; ++i) scale[i] = 1 / std::max(high[i] - low[i], 1e-6F);

  PerOrientation mass = {};
  PerOrientation moment = {};
  for (int j = 0; j < shifts; ++j) {
    const float preferred = energy_.preferred(j);
    for (int i = 0; i < n; ++i) {
      const float response = (energy[j][i] - low[i]) * scale[i];
      const float counted = response >= threshold_ ? response - subtract_ : 0.0F;
      mass[i] += counted;
      moment[i] += counted * preferred;
    }
  }
  PerOrientation disparity;
  for (int i = 0; i < n; ++i) disparity[i] = moment[i] / std::max(mass[i], 1e-6F);
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
