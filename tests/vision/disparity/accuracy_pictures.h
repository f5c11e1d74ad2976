// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>
#include <string>
#include <utility>
#include <vector>

#include "real_pair.h"
#include "vision/disparity/disparity_field.h"

namespace horopter::vision::testing {

/// A picture of fields beside the truth, 8-bit BGR: the left image and the true dx, then for each
/// field its dx in the same colours, invalid black, and its error, white from 2 px on. A row for
/// each, at most `width` px wide, named.
cv::Mat3b ComparePictures(const PairWithTruth& pair,
                          const std::vector<std::pair<std::string, DisparityField>>& fields,
                          int width);

}  // namespace horopter::vision::testing
