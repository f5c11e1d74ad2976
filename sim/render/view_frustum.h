// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <opencv2/core/types.hpp>
#include <vector>

#include "hardware/types/camera_model.h"
#include "hardware/types/config_error.h"
#include "hardware/types/pose.h"

namespace horopter::sim {

/// The pinhole as an OpenGL frustum. Pixel (0, 0) is a centre, so the image spans -0.5 to W - 0.5;
/// MuJoCo keeps left and right as a centre and a width that follows from the viewport's aspect.
mjvGLCamera FrustumOf(const hardware::Pose& X_WC, const hardware::Intrinsics& in, double near_m,
                      double far_m);

/// Why this cannot be rendered into an image of at most `largest`; empty when it can.
std::vector<hardware::FieldError> CheckView(const hardware::Pose& X_WC,
                                            const hardware::CameraModel& camera, cv::Size largest);

}  // namespace horopter::sim
