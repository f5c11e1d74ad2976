// SPDX-License-Identifier: Apache-2.0
#define HOROPTER_KERNELS avx2
#include "vision/disparity/closed_form_loops.h"

namespace horopter::vision {

extern const ClosedFormKernels k_avx2_kernels;
const ClosedFormKernels k_avx2_kernels = avx2::MakeKernels("avx2");

}  // namespace horopter::vision
