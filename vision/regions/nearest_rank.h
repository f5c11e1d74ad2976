// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace horopter::vision {

/// The value that `fraction` of the values may be less than, without interpolation. Reorders them.
/// @param values not empty
/// @param fraction in [0, 1)
inline float NearestRank(std::vector<float>& values, double fraction) {
  const auto nth =
      values.begin() + static_cast<std::ptrdiff_t>(fraction * static_cast<double>(values.size()));
  std::nth_element(values.begin(), nth, values.end());
  return *nth;
}

}  // namespace horopter::vision
