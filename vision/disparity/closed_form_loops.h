// SPDX-License-Identifier: Apache-2.0
#pragma once

// The loops of ClosedFormKernels, compiled once for each instruction set (lanes.h). Nothing in them
// may call a function of a library that is not inlined: the linker could give its code to all.

#include <string_view>

#include "vision/disparity/closed_form_kernels.h"
#include "vision/disparity/kernels_filter.h"
#include "vision/disparity/kernels_pool.h"
#include "vision/disparity/kernels_refine.h"
#include "vision/disparity/kernels_score.h"
#include "vision/disparity/kernels_smooth.h"

namespace horopter::vision::HOROPTER_KERNELS {

inline constexpr ClosedFormKernels MakeKernels(std::string_view name) {
  return {name,     FilterRow, ScoreNeighbours, ScoreShifts, MultiplyRow,     PoolRow,
          PoolDown, KeepBest,  Solve,           SmoothRow,   SmoothAcrossRows};
}

}  // namespace horopter::vision::HOROPTER_KERNELS
