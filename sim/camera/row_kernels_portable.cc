// SPDX-License-Identifier: Apache-2.0
#include "sim/camera/row_kernels.h"
#include "sim/camera/sampling_loops.h"
#include "sim/camera/sensor_loops.h"

namespace horopter::sim {

extern const RowKernels k_portable_row_kernels;
const RowKernels k_portable_row_kernels{"portable", portable::Sample, portable::Expose};

}  // namespace horopter::sim
