// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

namespace horopter::sim {

/// How an eye turned around the instant M that its image is of: R_MC(t) maps directions in the
/// optical frame at t to those at M, with t in seconds from M.
///
/// Samples are blended linearly, which for the few degrees between two physics steps misses the
/// rotation's direction by the third power of the angle (2 deg: 1e-6 rad). Before the first and
/// after the last sample the eye rests. Without samples it never moves.
class EyeMotion {
 public:
  void Clear() { samples_.clear(); }
  /// @pre later than all before
  void Add(double t_s, const Eigen::Matrix3d& R_MC) { samples_.push_back({t_s, R_MC}); }

  Eigen::Matrix3d At(double t_s) const;

  /// The largest angle from the instant M [rad].
  double LargestAngle() const;

 private:
  struct Sample {
    double t_s;
    Eigen::Matrix3d R_MC;
  };
  std::vector<Sample> samples_;
};

}  // namespace horopter::sim
