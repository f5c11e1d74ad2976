// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>

namespace horopter::vision {

/// What an image looks like once light and contrast of each neighbourhood are taken out, as retina
/// and lateral geniculate body do: (grey - m) / sqrt(s^2 + floor^2), with the mean m and the
/// deviation s of the window around each pixel. Borders are replicated. Chessa & Solari 2018, where
/// nothing but rounding takes the floor's place, so that noise alone becomes texture.
/// @param window_px side of the window, odd
/// @param floor_grey contrast that counts half, in grey levels; above 0
cv::Mat1f NormaliseLocally(const cv::Mat1f& grey, int window_px, double floor_grey);

}  // namespace horopter::vision
