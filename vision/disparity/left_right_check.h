// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "vision/disparity/disparity_field.h"

namespace horopter::vision {

/// Clears `valid` wherever a pixel's match lies outside the right image, or the match's own
/// disparity is invalid or leads back to more than `max_distance_px` from where it came.
/// An addition to the 2009 model: it finds half-occluded pixels and most false matches.
/// @param right_to_left the field estimated with the two images exchanged, of the same size
void CheckLeftRight(const DisparityField& right_to_left, double max_distance_px,
                    DisparityField& left_to_right);

/// Clears `valid` wherever a pixel's match lies outside the right image, and wherever the pixel or
/// its match is less than `border_px` from its image's border.
void InvalidateOutside(DisparityField& field, int border_px = 0);

/// Writes NaN into dx and dy, and 0 into the confidence, wherever `valid` is 0.
void BlankInvalid(DisparityField& field);

}  // namespace horopter::vision
