// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "hardware/types/pose.h"

namespace horopter::sim {

/// Where an eye was at one instant, seen from where it was at another, M.
struct EyePlace {
  Eigen::Matrix3d R_MC = Eigen::Matrix3d::Identity();  ///< from the optical frame then to that at M
  Eigen::Vector3d p_MC = Eigen::Vector3d::Zero();      ///< the optical centre then [m]
};

/// How an eye turned and moved around the instant M that its image is of, with t in seconds from M.
///
/// Samples are blended linearly, which for the few degrees between two physics steps misses the
/// rotation's direction by the third power of the angle (2 deg: 1e-6 rad). Before the first and
/// after the last sample the eye rests. Without samples it never moves.
class EyeMotion {
 public:
  void Clear() { samples_.clear(); }
  /// @pre later than all before
  void Add(double t_s, const Eigen::Matrix3d& R_MC,
           const Eigen::Vector3d& p_MC = Eigen::Vector3d::Zero()) {
    samples_.push_back({t_s, {R_MC, p_MC}});
  }

  EyePlace At(double t_s) const;
  /// X_MC(t), whose rotation is one to the last bit but rounding.
  hardware::Pose PoseAt(double t_s) const;

  /// The same motion seen from the optical frame V, wherever that is in M's.
  EyeMotion SeenFrom(const hardware::Pose& X_MV) const;

  /// The largest angle from the instant M [rad].
  double LargestAngle() const;
  /// The farthest that the optical centre was from its place at M [m].
  double LargestShift() const;

 private:
  struct Sample {
    double t_s;
    EyePlace place;
  };
  std::vector<Sample> samples_;
};

}  // namespace horopter::sim
