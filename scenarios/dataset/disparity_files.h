// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "vision/disparity/disparity_field.h"
#include "vision/disparity/field_score.h"

namespace horopter::scenarios {

/// @throws std::invalid_argument that lists the formats, unless WriteDisparity() knows the
/// extension
void RequireDisparityFormat(const std::filesystem::path& file);

/// Writes a field in the format that the extension names:
///
/// | extension | holds | unknown |
/// |---|---|---|
/// | .flo | x_right - x_left, y_right - y_left (flo.h) | above 1e9 |
/// | .pfm | x_left - x_right, as Middlebury's stereo benchmark (pfm.h) | +inf |
/// | .png | x_left - x_right, KITTI's 16 bits (png16.h) | 0 |
///
/// @return valid pixels that the format cannot hold (KITTI: not positive, or 256 px and more),
/// which
///         become unknown
/// @throws std::invalid_argument for any other extension; ResultsError
int WriteDisparity(const std::filesystem::path& file, const vision::DisparityField& field);

/// Reads a field, or a map of horizontal disparity (dy is then empty): besides the formats above
/// KITTI flow (three channels of 16 bits), and pictures of 8 bits and .pgm files, where 0 is
/// unknown.
/// @param scale value of a disparity of 1 px in such a picture; a PNG of 16 bits has KITTI's
/// @throws std::invalid_argument for any other extension (listing the known), or a scale that is
///         not positive; FormatError; UnusableResults when there is no such file
vision::DisparityMaps ReadDisparity(const std::filesystem::path& file, double scale = 1);

}  // namespace horopter::scenarios
