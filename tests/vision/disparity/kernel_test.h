// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "vision/disparity/closed_form_kernels.h"

namespace horopter::vision::testing {

/// A test of the loops of one instruction set: the parameter is its name.
class KernelTest : public ::testing::TestWithParam<std::string> {
 protected:
  const ClosedFormKernels& kernels_ = SelectKernels(GetParam());
};

/// The instruction sets that this processor runs, as values of a KernelTest.
inline auto EveryKernel() {
  std::vector<std::string> names;
  for (const std::string_view name : UsableKernels()) names.emplace_back(name);
  return ::testing::ValuesIn(names);
}

inline std::string NameOf(const ::testing::TestParamInfo<std::string>& info) { return info.param; }

}  // namespace horopter::vision::testing
