// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>

#include "vision/disparity/disparity_field.h"

namespace horopter::vision {

/// How far values are carried, and over how much colour: the domain transform of edge_map.h.
struct FillInConfig {
  double reach_px = 40;
  /// Sum of colour differences that counts as much as reach_px pixels.
  double colour_grey = 30;
  /// Passes along rows and columns.
  int passes = 3;
};

/// Gives every invalid pixel the mean disparity of the valid ones around it, each weighted by its
/// confidence and by how far it lies in the image and in colour: what only one eye sees mostly has
/// the colour of its background, and takes its disparity. Pixels filled are marked in `filled` and
/// keep confidence 0; a field without any valid pixel is left as it is.
///
/// The stage that Chessa & Solari (2018) do with a bilateral filter.
/// @param guide the left image, CV_8UC1 or CV_8UC3, of the field's size
void FillIn(const cv::Mat& guide, const FillInConfig& config, DisparityField& field);

}  // namespace horopter::vision
