// SPDX-License-Identifier: Apache-2.0
#include "sim/camera/row_kernels.h"
#include "sim/camera/sampling_loops_avx2.h"
#include "sim/camera/sensor_loops_avx2.h"

namespace horopter::sim {

extern const RowKernels k_avx2_row_kernels;
const RowKernels k_avx2_row_kernels{"avx2", avx2::Sample, avx2::Expose};

}  // namespace horopter::sim
