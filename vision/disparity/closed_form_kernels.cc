// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/closed_form_kernels.h"

#include <stdexcept>
#include <string>

namespace horopter::vision {

extern const ClosedFormKernels k_portable_kernels;
#if defined(HOROPTER_X86_KERNELS)
extern const ClosedFormKernels k_avx2_kernels, k_avx512_kernels;
#endif

namespace {

#if defined(HOROPTER_X86_KERNELS)
bool HasAvx2() { return __builtin_cpu_supports("avx2") != 0; }

bool HasAvx512() {
  return __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512bw") != 0 &&
         __builtin_cpu_supports("avx512dq") != 0 && __builtin_cpu_supports("avx512vl") != 0;
}
#endif

std::vector<const ClosedFormKernels*> Usable() {
  std::vector<const ClosedFormKernels*> usable;
#if defined(HOROPTER_X86_KERNELS)
  if (HasAvx512()) usable.push_back(&k_avx512_kernels);
  if (HasAvx2()) usable.push_back(&k_avx2_kernels);
#endif
  usable.push_back(&k_portable_kernels);
  return usable;
}

}  // namespace

const ClosedFormKernels& SelectKernels(std::string_view name) {
  const auto usable = Usable();
  if (name.empty()) return *usable.front();
  std::string known;
  for (const ClosedFormKernels* kernels : usable) {
    if (kernels->name == name) return *kernels;
    known += (known.empty() ? "" : ", ") + std::string(kernels->name);
  }
  throw std::invalid_argument("unknown or unsupported instruction set \"" + std::string(name) +
                              "\": this processor can run " + known);
}

std::vector<std::string_view> UsableKernels() {
  std::vector<std::string_view> names;
  for (const ClosedFormKernels* kernels : Usable()) names.push_back(kernels->name);
  return names;
}

}  // namespace horopter::vision
