// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "hardware/types/eye.h"
#include "hardware/types/pose.h"
#include "sim/truth/ground_truth.h"

namespace horopter::sim {

/// Angle between an eye's optical axis and the direction to a target, in [0, pi] rad.
/// @return NaN when the target is at the optical centre
double FixationError(const hardware::Pose& X_WC, const Eigen::Vector3d& p_WT);

/// The same for both eyes of the truth.
hardware::PerEye<double> FixationError(const GroundTruth& truth, const Eigen::Vector3d& p_WT);

}  // namespace horopter::sim
