// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>
#include <vector>

#include "vision/regions/depth_statistics.h"

namespace horopter::vision {

/// One connected region of the edge map.
struct Region {
  int label = 0;  ///< its value in the label image, from 1
  int area_px = 0;
  cv::Rect box;
  cv::Point2d centroid;
  cv::Scalar mean_bgr;  ///< zero where no image was given
  DepthStatistics depth;
};

/// All regions of one image.
struct RegionMap {
  cv::Mat1i labels;  ///< 0 on edges and in regions too small to count, otherwise a region's label
  std::vector<Region> regions;  ///< regions[i] has label i + 1
};

}  // namespace horopter::vision
