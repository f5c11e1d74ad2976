// SPDX-License-Identifier: Apache-2.0
#define HOROPTER_KERNELS portable
#include "vision/disparity/closed_form_loops.h"

namespace horopter::vision {

extern const ClosedFormKernels k_portable_kernels;
const ClosedFormKernels k_portable_kernels = portable::MakeKernels("portable");

}  // namespace horopter::vision
