// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>
#include <vector>

namespace horopter::vision {

/// Depth over a region's pixels that have one.
struct DepthStatistics {
  int count = 0;            ///< pixels with a depth; the rest of the struct is NaN when 0
  double mean_m = 0;
  double min_m = 0;
  double deviation_m = 0;
  double near_m = 0;        ///< 5th percentile: the minimum that a few wrong pixels cannot make
};

/// One connected region of the edge map.
struct Region {
  int label = 0;            ///< its value in the label image, from 1
  int area_px = 0;
  cv::Rect box;
  cv::Point2d centroid;
  cv::Scalar mean_bgr;
  DepthStatistics depth;
};

/// All regions of one image.
struct RegionMap {
  cv::Mat1i labels;         ///< 0 on edges, otherwise a region's label
  std::vector<Region> regions;
};

}  // namespace horopter::vision
