// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <vector>

namespace horopter::vision {

/// Depth over those pixels of a region that have one.
struct DepthStatistics {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

  int count = 0;  ///< pixels with a depth; the rest of the struct is NaN when 0
  double mean_m = kNone;
  double min_m = kNone;
  double deviation_m = kNone;  ///< of the population
  double near_m = kNone;       ///< 5th percentile: the minimum that a few wrong pixels cannot make
};

/// @param depths_m every depth, finite; reordered
/// @param near_fraction which part may be nearer than near_m (nearest rank), in [0, 1)
DepthStatistics Summarise(std::vector<float>& depths_m, double near_fraction = 0.05);

}  // namespace horopter::vision
