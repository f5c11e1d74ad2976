// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/linear_readout.h"

#include <algorithm>
#include <cmath>

namespace horopter::vision {
namespace {

/// By how much the weights of a pooling filter may miss 1.
constexpr double kRounding = 1e-4;

}  // namespace

LinearReadout::LinearReadout(const V1Config& config)
    : energy_(config),
      pairs_(config.phase_shifts / 2),
      min_pooled_(static_cast<float>(config.min_pooled - kRounding)),
      peak_frequency_(config.peak_frequency) {
  for (int i = 0; i < energy_.orientations(); ++i) {
    nx_[i] = static_cast<float>(std::cos(OrientationRad(i, energy_.orientations())));
    ny_[i] = static_cast<float>(std::sin(OrientationRad(i, energy_.orientations())));
  }
  gain_ = static_cast<float>(config.readout_gain) * Calibrate(config.max_disparity_px / 2);
}

void LinearReadout::Sense(const SimpleCells& left, const SimpleCells& right,
                          float textureless_energy, float* sums) const {
  std::fill_n(sums, floats(), 0.0F);
  const int orientations = energy_.orientations();
  const int shifts = energy_.phase_shifts();
  BinocularEnergy::Energies energy;
  energy_.Magnitudes<0, 0>(left, right, energy);
  float total = 0;
  for (int j = 0; j < shifts; ++j) {
    for (int i = 0; i < orientations; ++i) total += energy[j][i];
  }
  if (total < textureless_energy * static_cast<float>(orientations * shifts)) return;

  energy_.Compress(energy);
  float* drive = sums + kOthers;
  for (int pair = 0; pair < pairs_; ++pair) {
    const PerOrientation& towards = energy[shifts - 1 - pair];
    const PerOrientation& away = energy[pair];
    float all = 0, along_x = 0, along_y = 0;
    for (int i = 0; i < orientations; ++i) {
      all += towards[i] + away[i];
      along_x += nx_[i] * (towards[i] - away[i]);
      along_y += ny_[i] * (towards[i] - away[i]);
    }
    if (!(all > 0)) continue;
    drive[pair] = along_x / all;
    drive[pairs_ + pair] = along_y / all;
  }
  sums[kWeight] = 1;
  for (int i = 0; i < orientations; ++i) {
    sums[kAgreement] += 2 * (left.even[i] * right.even[i] + left.odd[i] * right.odd[i]);
    sums[kPower] += left.even[i] * left.even[i] + left.odd[i] * left.odd[i] +
                    right.even[i] * right.even[i] + right.odd[i] * right.odd[i];
  }
}

PopulationDisparity LinearReadout::Read(const float* pooled) const {
  PopulationDisparity out;
  if (!(pooled[kWeight] >= min_pooled_) || !(pooled[kPower] > 0)) return out;
  const float gain = gain_ / pooled[kWeight];
  out.dx = Decode(pooled + kOthers, gain);
  out.dy = Decode(pooled + kOthers + pairs_, gain);
  out.correlation = pooled[kAgreement] / pooled[kPower];
  out.solved = true;
  return out;
}

float LinearReadout::Decode(const float* drive, float gain) const {
  float sum = 0;
  for (int pair = 0; pair < pairs_; ++pair) {
    const float preferred = energy_.preferred(energy_.phase_shifts() - 1 - pair);
    sum += 2 * preferred * std::sinh(gain * drive[pair]);
  }
  return sum;
}

float LinearReadout::Calibrate(double disparity_px) const {
  PerOrientation one, zero{}, even, odd;
  one.fill(1);
  for (int i = 0; i < energy_.orientations(); ++i) {
    const double phase = -2 * M_PI * peak_frequency_ * disparity_px * nx_[i];
    even[i] = static_cast<float>(std::cos(phase));
    odd[i] = static_cast<float>(std::sin(phase));
  }
  std::array<float, 2 * kMaxPhaseShifts + kOthers> sums;
  Sense({one.data(), zero.data()}, {even.data(), odd.data()}, 0, sums.data());
  // What is decoded rises with the gain, from 0 without bound.
  float low = 0, high = 1;
  while (Decode(sums.data() + kOthers, high) < static_cast<float>(disparity_px)) high *= 2;
  for (int step = 0; step < 40; ++step) {
    const float middle = (low + high) / 2;
    const bool less = Decode(sums.data() + kOthers, middle) < static_cast<float>(disparity_px);
    (less ? low : high) = middle;
  }
  return high;
}

}  // namespace horopter::vision
