// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/pyramid.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace horopter::vision {
namespace {

cv::Mat Upsample(const cv::Mat& coarse, cv::Size fine, int interpolation) {
  // cv::resize would align the corners of the corner pixels, not their centres.
  const cv::Matx23d coarse_from_fine(0.5, 0, 0, 0, 0.5, 0);
  cv::Mat out;
  cv::warpAffine(coarse, out, coarse_from_fine, fine, interpolation | cv::WARP_INVERSE_MAP,
                 cv::BORDER_REPLICATE);
  return out;
}

}  // namespace

std::vector<cv::Mat1f> BuildPyramid(const cv::Mat1f& image, int scales, int min_side_px) {
  std::vector<cv::Mat1f> octaves = {image};
  while (static_cast<int>(octaves.size()) < scales) {
    const cv::Size half((octaves.back().cols + 1) / 2, (octaves.back().rows + 1) / 2);
    if (std::min(half.width, half.height) < min_side_px) break;
    cv::Mat1f next;
    cv::pyrDown(octaves.back(), next, half, cv::BORDER_REPLICATE);
    octaves.push_back(next);
  }
  return octaves;
}

cv::Mat1f UpsampleDisparity(const cv::Mat1f& coarse, cv::Size fine) {
  return 2 * Upsample(coarse, fine, cv::INTER_LINEAR);
}

cv::Mat UpsampleNearest(const cv::Mat& coarse, cv::Size fine) {
  return Upsample(coarse, fine, cv::INTER_NEAREST);
}

}  // namespace horopter::vision
