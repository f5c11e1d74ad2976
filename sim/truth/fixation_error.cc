// SPDX-License-Identifier: Apache-2.0
#include "sim/truth/fixation_error.h"

#include <cmath>
#include <limits>

namespace horopter::sim {

double FixationError(const hardware::Pose& X_WC, const Eigen::Vector3d& p_WT) {
  const Eigen::Vector3d p_CT = X_WC.inverse() * p_WT;
  if (p_CT.isZero(0)) return std::numeric_limits<double>::quiet_NaN();
  // Not an arc cosine: that loses all digits where the error is small.
  return std::atan2(p_CT.head<2>().norm(), p_CT.z());
}

hardware::PerEye<double> FixationError(const GroundTruth& truth, const Eigen::Vector3d& p_WT) {
  return {FixationError(truth.left.view.X_WC, p_WT), FixationError(truth.right.view.X_WC, p_WT)};
}

}  // namespace horopter::sim
