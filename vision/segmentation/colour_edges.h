// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "hardware/types/config_error.h"

namespace horopter::vision {

enum class GradientKernel {
  kCentral,  ///< [-1 0 1] and its transpose
  kSobel,    ///< 3x3, divided by 4: the same answer as kCentral on a straight edge
};

/// Defaults are the paper's (Figure 2).
struct ColourEdgesConfig {
  int median_px = 11;  ///< window of the median filter; 1: no filter
  GradientKernel kernel = GradientKernel::kCentral;
  int threshold = 21;  ///< a larger L1 norm of the six gradient components makes an edge

  std::vector<hardware::FieldError> Validate() const;
};

/// Boundaries between differently coloured surfaces, thick enough to separate their interiors
/// (Chessa et al. 2014, "Image Acquisition and Segmentation"): median filter, gradient of every
/// channel in x and y, sum of the six absolute values, threshold. Pixels beyond the border repeat
/// the outermost ones.
/// @param bgr CV_8UC3, at least 1x1
/// @return 0 on edges, 255 in interiors
/// @throws hardware::ConfigError; std::invalid_argument for another type or an empty image
cv::Mat1b FindColourEdges(const cv::Mat& bgr, const ColourEdgesConfig& config = {});

}  // namespace horopter::vision
