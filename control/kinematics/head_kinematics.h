// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "hardware/types/config_error.h"
#include "hardware/types/eye.h"
#include "hardware/types/head_angles.h"
#include "hardware/types/head_geometry.h"
#include "hardware/types/pose.h"

namespace horopter::control {

/// Every bad field of a head's geometry: lengths are finite and not negative, the baseline is
/// positive, X_BN is a rigid motion.
std::vector<hardware::FieldError> Validate(const hardware::HeadGeometry& geometry);

/// X_BH: the head frame (body axes, midway between the eyes' pan axes) in the base. Depends on the
/// neck's angles alone.
hardware::Pose HeadPose(const hardware::HeadGeometry& geometry, const hardware::PanTilt& neck);

/// X_BC: an eye's optical frame (x right, y down, z forward; origin in the optical centre) in the
/// base.
hardware::Pose EyePose(const hardware::HeadGeometry& geometry, const hardware::HeadAngles& angles,
                       hardware::Eye eye);

/// X_ClCr: the right optical frame in the left one, which is all that two views have in common
/// when nobody asks where the head is.
hardware::Pose RightEyeInLeft(const hardware::HeadGeometry& geometry,
                              const hardware::HeadAngles& angles);

/// Where the two optical axes meet, or come nearest.
struct FixationPoint {
  Eigen::Vector3d p_B;  ///< midpoint of the shortest segment between the axes [m]
  double gap_m = 0;     ///< length of that segment
};

/// @return nothing when the axes are parallel (to 1e-9 rad) or come nearest behind an eye.
std::optional<FixationPoint> FindFixationPoint(const hardware::HeadGeometry& geometry,
                                               const hardware::HeadAngles& angles);

}  // namespace horopter::control
