// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "hardware/types/config_error.h"
#include "vision/regions/region.h"

namespace horopter::vision {

struct RegionConfig {
  int min_area_px = 50;         ///< smaller regions count as edges
  double near_fraction = 0.05;  ///< for DepthStatistics::near_m

  std::vector<hardware::FieldError> Validate() const;
};

/// The 8-connected regions of an edge map (the blobs of Chessa et al. 2014), with what is known of
/// each: area, box, centroid, mean colour and depth statistics.
///
/// Labels count from 1 in the order in which a scan by rows first meets each region, whatever the
/// number of threads. Linear in the number of pixels.
/// @param interior not 0 inside regions, 0 on edges (FindColourEdges())
/// @param bgr CV_8UC3 of the same size, or empty
/// @param depth of the same size [m], values that are not finite are missing; or empty. Whatever
///        distance is given here is what the statistics are of.
/// @throws hardware::ConfigError; std::invalid_argument when sizes or types do not match
RegionMap ExtractRegions(const cv::Mat1b& interior, const cv::Mat& bgr, const cv::Mat1f& depth,
                         const RegionConfig& config = {});

}  // namespace horopter::vision
