// SPDX-License-Identifier: Apache-2.0
#include "sim/camera/eye_motion.h"

#include <algorithm>
#include <cmath>

namespace horopter::sim {

Eigen::Matrix3d EyeMotion::At(double t_s) const {
  if (samples_.empty()) return Eigen::Matrix3d::Identity();
  const auto after = std::lower_bound(samples_.begin(), samples_.end(), t_s,
                                      [](const Sample& s, double t) { return s.t_s < t; });
  if (after == samples_.end()) return samples_.back().R_MC;
  if (after == samples_.begin()) return samples_.front().R_MC;
  const Sample& before = *(after - 1);
  const double share = (t_s - before.t_s) / (after->t_s - before.t_s);
  return (1 - share) * before.R_MC + share * after->R_MC;
}

double EyeMotion::LargestAngle() const {
  double largest = 0;
  for (const Sample& sample : samples_) {
    // |R - I| (Frobenius) = 2 sqrt(2) sin(angle / 2), which is exact for small angles too.
    const double chord = (sample.R_MC - Eigen::Matrix3d::Identity()).norm() / (2 * M_SQRT2);
    largest = std::max(largest, 2 * std::asin(std::min(1.0, chord)));
  }
  return largest;
}

}  // namespace horopter::sim
