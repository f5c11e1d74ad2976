// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

namespace horopter::vision::testing {

/// Calls `function()` where its parallel loops have `count` threads, however many processors there
/// are: the arena has as many slots, and as many threads are allowed to fill them.
template <typename Function>
auto OnThreads(int count, Function function) {
  const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism, count);
  tbb::task_arena arena(count);
  return arena.execute(function);
}

}  // namespace horopter::vision::testing
