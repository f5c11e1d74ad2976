// SPDX-License-Identifier: Apache-2.0
#include "sim/camera/eye_motion.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace horopter::sim {

using hardware::Pose;

EyePlace EyeMotion::At(double t_s) const {
  if (samples_.empty()) return {};
  const auto after = std::lower_bound(samples_.begin(), samples_.end(), t_s,
                                      [](const Sample& s, double t) { return s.t_s < t; });
  if (after == samples_.end()) return samples_.back().place;
  if (after == samples_.begin()) return samples_.front().place;
  const Sample& before = *(after - 1);
  const double share = (t_s - before.t_s) / (after->t_s - before.t_s);
  return {(1 - share) * before.place.R_MC + share * after->place.R_MC,
          (1 - share) * before.place.p_MC + share * after->place.p_MC};
}

Pose EyeMotion::PoseAt(double t_s) const {
  const EyePlace place = At(t_s);
  Pose X_MC = Pose::Identity();
  X_MC.linear() = Eigen::Quaterniond(place.R_MC).normalized().toRotationMatrix();
  X_MC.translation() = place.p_MC;
  return X_MC;
}

EyeMotion EyeMotion::SeenFrom(const Pose& X_MV) const {
  const Pose X_VM = X_MV.inverse();
  EyeMotion seen;
  for (const Sample& sample : samples_) {
    seen.Add(sample.t_s, X_VM.linear() * sample.place.R_MC, X_VM * sample.place.p_MC);
  }
  return seen;
}

double EyeMotion::LargestAngle() const {
  double largest = 0;
  for (const Sample& sample : samples_) {
    // |R - I| (Frobenius) = 2 sqrt(2) sin(angle / 2), which is exact for small angles too.
    const double chord = (sample.place.R_MC - Eigen::Matrix3d::Identity()).norm() / (2 * M_SQRT2);
    largest = std::max(largest, 2 * std::asin(std::min(1.0, chord)));
  }
  return largest;
}

double EyeMotion::LargestShift() const {
  double largest = 0;
  for (const Sample& sample : samples_) largest = std::max(largest, sample.place.p_MC.norm());
  return largest;
}

}  // namespace horopter::sim
