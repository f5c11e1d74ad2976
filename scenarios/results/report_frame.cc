// SPDX-License-Identifier: Apache-2.0
#include "scenarios/results/report_frame.h"

#include <cassert>
#include <cmath>

namespace horopter::scenarios {

const char* FileSuffix(PictureKind kind) {
  switch (kind) {
    case PictureKind::kLeft:
      return "left";
    case PictureKind::kRight:
      return "right";
    case PictureKind::kRegions:
      return "regions";
    case PictureKind::kDisparity:
      return "disparity";
    case PictureKind::kDepth:
      return "depth";
    case PictureKind::kTrueDepth:
      return "true_depth";
    case PictureKind::kDepthError:
      return "depth_error";
  }
  assert(false);
  return "";
}

std::vector<std::size_t> EvenlySpaced(std::size_t count, std::size_t most) {
  assert(most >= 1);
  std::vector<std::size_t> chosen;
  if (count == 0) return chosen;
  if (count <= most) {
    for (std::size_t i = 0; i < count; ++i) chosen.push_back(i);
    return chosen;
  }
  if (most == 1) return {count - 1};
  for (std::size_t i = 0; i < most; ++i) {
    chosen.push_back(static_cast<std::size_t>(
        std::lround(static_cast<double>(i) * static_cast<double>(count - 1) / (most - 1.0))));
  }
  return chosen;
}

}  // namespace horopter::scenarios
