// SPDX-License-Identifier: Apache-2.0
#include "vision/regions/depth_statistics.h"

#include <algorithm>
#include <cmath>

namespace horopter::vision {

DepthStatistics Summarise(std::vector<float>& depths_m, double near_fraction) {
  DepthStatistics s;
  if (depths_m.empty()) return s;
  const auto n = static_cast<std::ptrdiff_t>(depths_m.size());
  s.count = static_cast<int>(n);

  // Sums before the selection below reorders them: they are then those of the pixels' order.
  double sum = 0;
  for (const float d : depths_m) sum += d;
  s.mean_m = sum / static_cast<double>(n);
  double squares = 0;
  for (const float d : depths_m) squares += (d - s.mean_m) * (d - s.mean_m);
  s.deviation_m = std::sqrt(squares / static_cast<double>(n));

  s.min_m = *std::min_element(depths_m.begin(), depths_m.end());
  const auto rank = static_cast<std::ptrdiff_t>(std::floor(near_fraction * static_cast<double>(n)));
  const auto near = depths_m.begin() + std::clamp<std::ptrdiff_t>(rank, 0, n - 1);
  std::nth_element(depths_m.begin(), near, depths_m.end());
  s.near_m = *near;
  return s;
}

}  // namespace horopter::vision
