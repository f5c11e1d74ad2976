// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "vision/disparity/disparity_field.h"

namespace horopter::vision {

/// Clears `valid` in every segment of fewer than `min_px` pixels. A segment is a set of valid
/// pixels, connected through their four neighbours, whose disparities differ by at most
/// `max_step_px` from one to the next. False matches come as small islands; surfaces do not.
/// Nearly linear in the number of pixels.
void InvalidateSmallSegments(int min_px, double max_step_px, DisparityField& field);

}  // namespace horopter::vision
