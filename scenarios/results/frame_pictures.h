// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>

#include "hardware/types/stereo_frame.h"
#include "scenarios/results/run_record.h"
#include "vision/disparity/disparity_field.h"
#include "vision/regions/region.h"

namespace horopter::scenarios {

/// All pictures of one vision cycle, coloured by one set of scales.
/// @param depth_m estimated depth of the left image's pixels along its optical axis; NaN = none
/// @param true_depth_m likewise by truth, or empty where there is no truth: the true depth and the
///        error are then left out
/// @throws std::invalid_argument when sizes differ or a scale is no scale
FrameImages MakeFrameImages(const hardware::StereoFrame& frame,
                            const vision::DisparityField& disparity, const cv::Mat1f& depth_m,
                            const cv::Mat1f& true_depth_m, const vision::RegionMap& regions,
                            const ColourScales& scales = {});

}  // namespace horopter::scenarios
