// SPDX-License-Identifier: Apache-2.0
#define HOROPTER_KERNELS avx512
#include "vision/disparity/closed_form_loops.h"

namespace horopter::vision {

extern const ClosedFormKernels k_avx512_kernels;
const ClosedFormKernels k_avx512_kernels = avx512::MakeKernels("avx512");

}  // namespace horopter::vision
