// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "sim/truth/ground_truth.h"

namespace horopter::scenarios {

/// The cameras of a pair at one instant.
struct StereoViews {
  sim::EyeView left;
  sim::EyeView right;
};

/// A pair of cameras as YAML that cv::FileStorage reads, in the names and conventions of
/// cv::stereoCalibrate: `size1`, `K1` (3x3), `D1` (k1 k2 p1 p2 k3) of the left camera, `size2`,
/// `K2`, `D2` of the right, and `R`, `T` with x_right = R x_left + T in metres. `X_WC1` and `X_WC2`
/// (4x4) are the poses of both optical frames in the world. Numbers to 16 digits.
std::string EncodeCameras(const StereoViews& views);

/// @param name of the file, for messages
/// @throws FormatError when it is no such YAML, a matrix is missing or of another size, R and T
///         contradict the poses, or an entry gives no camera
StereoViews DecodeCameras(std::string_view yaml, const std::string& name);

}  // namespace horopter::scenarios
