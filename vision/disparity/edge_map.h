// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>

#include "vision/disparity/cell_image.h"
#include "vision/disparity/closed_form_kernels.h"

namespace horopter::vision {

/// Differences of colour between neighbours, which pooling does not cross: for each pixel the sum
/// over channels of |difference| to the one left of it (x) and above it (y), 255 at most; a grey
/// image counts as three equal channels.
struct EdgeMap {
  PaddedMap<std::uint8_t> x, y;
};

/// @param image CV_8UC1 or CV_8UC3
/// @param ignored what noise makes, taken off every difference
void FindEdges(const cv::Mat& image, int ignored, EdgeMap& edges);

/// The weights of a domain transform filter (Gastal & Oliveira, SIGGRAPH 2011, recursive form, one
/// pass): exp(-sqrt(2) / deviation_px * (1 + deviation_px / colour_grey * difference)).
PoolingWeights MakePoolingWeights(double deviation_px, double colour_grey);

}  // namespace horopter::vision
