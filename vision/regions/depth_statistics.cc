// SPDX-License-Identifier: Apache-2.0
#include "vision/regions/depth_statistics.h"

#include <algorithm>
#include <cmath>

#include "vision/regions/nearest_rank.h"

namespace horopter::vision {

DepthStatistics Summarise(std::vector<float>& depths_m, double near_fraction) {
  DepthStatistics s;
  if (depths_m.empty()) return s;
  const double n = static_cast<double>(depths_m.size());
  s.count = static_cast<int>(depths_m.size());

  // Sums before the selection below reorders them: they are then those of the pixels' order.
  double sum = 0;
  for (const float d : depths_m) sum += d;
  s.mean_m = sum / n;
  double squares = 0;
  for (const float d : depths_m) squares += (d - s.mean_m) * (d - s.mean_m);
  s.deviation_m = std::sqrt(squares / n);

  s.min_m = *std::min_element(depths_m.begin(), depths_m.end());
  s.near_m = NearestRank(depths_m, near_fraction);
  return s;
}

}  // namespace horopter::vision
