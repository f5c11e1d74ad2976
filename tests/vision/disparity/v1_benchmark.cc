// SPDX-License-Identifier: Apache-2.0
// Ours beside OpenCV's DIS on the same pair:
//   horopter_benchmark_vision_disparity --benchmark_filter=Estimate --benchmark_min_time=0.2
#include <benchmark/benchmark.h>

#include <opencv2/core/utility.hpp>
#include <string>

#include "on_threads.h"
#include "textured_pair.h"
#include "vision/disparity/disparity_factory.h"

namespace horopter::vision {
namespace {

void Estimate(benchmark::State& state, const char* method, const char* preset) {
  const cv::Size size(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  const int threads = static_cast<int>(state.range(2));
  // Of fine texture, which looks like noise, "accurate" and "fast" would match only half the size.
  const testing::SyntheticPair pair =
      testing::ShiftedPair(size, -7.6, 1.3, 1, testing::kCleanTexturePx);
  const auto estimator = CreateDisparityEstimator(method, preset);
  // OpenCV's loops and ours ask different libraries how many threads there are.
  testing::OnThreads(threads, [&] {
    cv::setNumThreads(threads);
    for (auto _ : state) benchmark::DoNotOptimize(estimator->Estimate(pair.left, pair.right));
  });
  cv::setNumThreads(-1);
}

void Sizes(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgNames({"width", "height", "threads"})->Unit(benchmark::kMillisecond)->UseRealTime();
  for (const int threads : {1, 2}) {
    benchmark->Args({320, 240, threads});
    benchmark->Args({640, 480, threads});
  }
}

BENCHMARK_CAPTURE(Estimate, v1_accurate, "v1", "accurate")->Apply(Sizes);
BENCHMARK_CAPTURE(Estimate, v1_fast, "v1", "fast")->Apply(Sizes);
BENCHMARK_CAPTURE(Estimate, v1_realtime, "v1", "realtime")->Apply(Sizes);
BENCHMARK_CAPTURE(Estimate, v1_checked, "v1", "checked")->Apply(Sizes);
BENCHMARK_CAPTURE(Estimate, v1_paper_2009, "v1", "paper_2009")->Apply(Sizes);
BENCHMARK_CAPTURE(Estimate, v1_paper_2018, "v1", "paper_2018")->Apply(Sizes);
BENCHMARK_CAPTURE(Estimate, dis_medium, "dis", "medium")->Apply(Sizes);
BENCHMARK_CAPTURE(Estimate, dis_ultrafast, "dis", "ultrafast")->Apply(Sizes);

}  // namespace
}  // namespace horopter::vision
