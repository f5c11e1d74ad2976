// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>

#include "vision/disparity/disparity_field.h"

namespace horopter::scenarios {

/// A field as one shows it: dx, and beside it dy, each with a title and its colour scale; invalid
/// pixels are grey. A field whose dy is 0 everywhere has one panel.
///
/// Scales reach from the 2nd to the 98th percentile of the valid pixels: where these have one sign
/// they are sequential, else symmetric about white zero.
/// @return CV_8UC3 BGR
cv::Mat3b DisparityPicture(const vision::DisparityField& field);

}  // namespace horopter::scenarios
