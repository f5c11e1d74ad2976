// SPDX-License-Identifier: Apache-2.0
#include "scenarios/results/frame_pictures.h"

#include <fmt/format.h>

#include <stdexcept>

#include "scenarios/results/colourise.h"

namespace horopter::scenarios {
namespace {

void RequireSize(const char* what, const cv::Size& size, const cv::Size& image) {
  if (size == image) return;
  throw std::invalid_argument(fmt::format("{} of {}x{} beside an image of {}x{}", what, size.width,
                                          size.height, image.width, image.height));
}

}  // namespace

FrameImages MakeFrameImages(const hardware::StereoFrame& frame,
                            const vision::DisparityField& disparity, const cv::Mat1f& depth_m,
                            const cv::Mat1f& true_depth_m, const vision::RegionMap& regions,
                            const ColourScales& scales) {
  const cv::Size size = frame.left.bgr.size();
  RequireSize("disparity", disparity.dx.size(), size);
  RequireSize("depth", depth_m.size(), size);

  FrameImages images;
  images.scales = scales;
  images.left_bgr = frame.left.bgr;
  images.right_bgr = frame.right.bgr;
  images.disparity_bgr = ColouriseDisparity(disparity, scales.disparity_px);
  images.depth_bgr = ColouriseDepth(depth_m, scales.near_m, scales.far_m);
  images.regions_bgr = DrawRegions(frame.left.bgr, regions, scales.near_m, scales.far_m);
  if (true_depth_m.empty()) return images;

  RequireSize("true depth", true_depth_m.size(), size);
  images.true_depth_bgr = ColouriseDepth(true_depth_m, scales.near_m, scales.far_m);
  const cv::Mat1f relative_error = (depth_m - true_depth_m) / true_depth_m;
  images.depth_error_bgr = ColouriseSignedError(relative_error, scales.relative_error);
  return images;
}

}  // namespace horopter::scenarios
