// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "vision/disparity/disparity_field.h"

namespace horopter::vision {

/// A field of one octave for every pixel of the octave below, in its pixels. Pixel (x, y) of the
/// coarse one lies on (2x, 2y). A pixel between two or four of them takes the side of the one that
/// its colour is closest to: its validity and confidence, and its disparity averaged with those of
/// the others that are valid and within a coarse pixel of it.
/// @param image the finer octave, CV_8UC1 or CV_8UC3, of twice the field's size or one less
void DoubleField(const cv::Mat& image, DisparityField& field);

}  // namespace horopter::vision
