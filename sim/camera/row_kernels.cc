// SPDX-License-Identifier: Apache-2.0
#include "sim/camera/row_kernels.h"

#include <vector>

namespace horopter::sim {

extern const RowKernels k_portable_row_kernels;
#if defined(HOROPTER_X86_KERNELS)
extern const RowKernels k_avx2_row_kernels;
#endif

std::span<const RowKernels* const> UsableRowKernels() {
  static const std::vector<const RowKernels*> usable = [] {
    std::vector<const RowKernels*> found;
#if defined(HOROPTER_X86_KERNELS)
    if (__builtin_cpu_supports("avx2") != 0) found.push_back(&k_avx2_row_kernels);
#endif
    found.push_back(&k_portable_row_kernels);
    return found;
  }();
  return usable;
}

}  // namespace horopter::sim
