// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>

#include "hardware/types/pose.h"

namespace horopter::vision {

/// A 3D point for every pixel of the left image (an organised cloud).
///
/// Which frame the points are in is said by the function that made them; body axes (x forward,
/// y left, z up), metres.
struct PointField {
  cv::Mat3f points;      ///< (x, y, z) [m]; NaN in all three where there is none
  cv::Mat1f residual_m;  ///< how far the two rays pass from the point [m]; NaN likewise
};

/// The same points in frame A, given the pose X_AB of the frame B they are in.
PointField Transformed(const PointField& field_B, const hardware::Pose& X_AB);

/// Depth along the optical axis of camera C (z of the optical frame) for points in frame B [m];
/// NaN where there is no point. With X_BC of the left eye this is the left image's depth map.
cv::Mat1f DepthAlongOptical(const PointField& field_B, const hardware::Pose& X_BC);

}  // namespace horopter::vision
