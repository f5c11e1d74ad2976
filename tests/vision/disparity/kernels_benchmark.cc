// SPDX-License-Identifier: Apache-2.0
// Each loop of the closed form in every instruction set that runs here, on one thread:
//   horopter_benchmark_vision_disparity --benchmark_filter=Kernel
// items_per_second counts pixels.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdint>
#include <opencv2/core.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "on_threads.h"
#include "random_cells.h"
#include "vision/disparity/closed_form_kernels.h"
#include "vision/disparity/edge_map.h"

namespace horopter::vision {
namespace {

/// A field of 320 x 240 and what the loops need around it. Disparities are smooth, as in a search.
class Scene {
 public:
  Scene() {
    cv::RNG random(1);
    for (int i = 0; i < kPixels; ++i) {
      grey_[i] = static_cast<float>(random.uniform(0, 256));
      edge_x_[i] = edge_y_[i] = static_cast<std::uint8_t>(random.uniform(0, 20));
      dx_[i] = static_cast<float>(5 + random.gaussian(0.2));
      dy_[i] = static_cast<float>(-2 + random.gaussian(0.2));
      hypothesis_x_[i] = static_cast<std::int16_t>(16 * dx_[i]);
      hypothesis_y_[i] = static_cast<std::int16_t>(16 * dy_[i]);
    }
    for (std::int16_t& lane : lanes_) lane = static_cast<std::int16_t>(random.uniform(-9000, 9000));
    solve_.pool = Columns();
    solve_.orientations = bank_.orientations();
    for (int o = 0; o < bank_.orientations(); ++o) {
      solve_.nx[o] = static_cast<float>(bank_.nx(o));
      solve_.ny[o] = static_cast<float>(bank_.ny(o));
    }
    solve_.px_per_rad = static_cast<float>(bank_.px_per_rad());
    solve_.ridge = 0.02F;
    solve_.max_step_px = 1e-3F;  // the field stays about what it is
    solve_.dx = dx_.data();
    solve_.dy = dy_.data();
  }

  void FilterRow(const ClosedFormKernels& kernels) {
    // Its rows run on the threads that there are: a single one here.
    bank_.Apply(kernels, grey_.data(), kWidth, kHeight, filtered_);
  }
  void ScoreNeighbours(const ClosedFormKernels& kernels) {
    const NeighbourTask task{left_.view(),         right_.view(),   hypothesis_x_.data(),
                             hypothesis_y_.data(), &bank_.tables(), &candidates_,
                             scores_.data()};
    for (int y = 0; y < kHeight; ++y) kernels.score_neighbours(task, y);
  }
  void ScoreShifts(const ClosedFormKernels& kernels) {
    const ShiftTask task{left_.view(),  right_.view(), hypothesis_y_.data(), &bank_.tables(), -8, 0,
                         scores_.data()};
    for (int y = 0; y < kHeight; ++y) kernels.score_shifts(task, y);
  }
  void MultiplyRow(const ClosedFormKernels& kernels) {
    const ProductTask task{left_.view(), right_.view(),   dx_.data(),
                           dy_.data(),   &bank_.tables(), scores_.data()};
    for (int y = 0; y < kHeight; ++y) kernels.multiply_row(task, y);
  }
  void PoolRow(const ClosedFormKernels& kernels) {
    for (int y = 0; y < kHeight; ++y) {
      kernels.pool_row(lanes_.data() + y * kWidth * kLanes, edge_x_.data() + y * kWidth, weights_,
                       kWidth);
    }
  }
  void PoolDown(const ClosedFormKernels& kernels) {
    kernels.pool_down(Columns(), 0, kHeight, 0, kWidth);
  }
  void KeepBest(const ClosedFormKernels& kernels) {
    const KeepTask task{Columns(), kLanes, true, 240, 0, best_.data(), winner_.data()};
    for (int x = 0; x < kWidth; x += kColumnsAtOnce) {
      kernels.keep_best(task, x, std::min(x + kColumnsAtOnce, kWidth));
    }
  }
  void Solve(const ClosedFormKernels& kernels) {
    for (int x = 0; x < kWidth; x += kColumnsAtOnce) {
      kernels.solve(solve_, x, std::min(x + kColumnsAtOnce, kWidth));
    }
  }
  void SmoothRow(const ClosedFormKernels& kernels) {
    for (int y = 0; y < kHeight; ++y) kernels.smooth_row(Smoothing(), y, scratch_.data());
  }
  void SmoothAcrossRows(const ClosedFormKernels& kernels) {
    for (int y = 0; y < kHeight; ++y) kernels.smooth_across_rows(Smoothing(), y);
  }

  static constexpr int kWidth = 320, kHeight = 240, kPixels = kWidth * kHeight;

 private:
  template <typename Value>
  static std::vector<Value> Map(int per_pixel = 1) {
    return std::vector<Value>((kPixels + 16) * per_pixel);
  }
  ColumnPool Columns() { return {lanes_.data(), kWidth, kHeight, edge_y_.data(), &weights_}; }
  SmoothTask Smoothing() {
    return {dx_.data(), dy_.data(), out_dx_.data(), out_dy_.data(), kWidth, kHeight, kSmoothPx, 1};
  }

  static constexpr int kSmoothPx = 4;
  CellBank bank_{ClosedFormConfig()};
  CellImage left_ = testing::RandomCells({kWidth, kHeight}, bank_.orientations(), 1);
  CellImage right_ = testing::RandomCells({kWidth, kHeight}, bank_.orientations(), 2);
  CellImage filtered_;
  PoolingWeights weights_ = MakePoolingWeights(4, 20);
  Candidates candidates_{.from_x = {0, 1, -1, 0, 0, 4, -4, 0, 0, 14, -14, 0, 0, 44, -44, 0},
                         .from_y = {0, 0, 0, -1, 1, 0, 0, -4, 4, 0, 0, -14, 14, 0, 0, -44},
                         .move_x = {},
                         .move_y = {}};
  std::vector<float> grey_ = Map<float>(), dx_ = Map<float>(), dy_ = Map<float>();
  std::vector<float> out_dx_ = Map<float>(), out_dy_ = Map<float>();
  std::vector<float> scratch_ = std::vector<float>(2 * PaddedRow(kWidth, kSmoothPx));
  std::vector<std::uint8_t> edge_x_ = Map<std::uint8_t>(), edge_y_ = Map<std::uint8_t>();
  std::vector<std::int16_t> hypothesis_x_ = Map<std::int16_t>(), hypothesis_y_ = hypothesis_x_;
  std::vector<std::int16_t> lanes_ = Map<std::int16_t>(kLanes), scores_ = lanes_;
  std::vector<std::int16_t> best_ = Map<std::int16_t>();
  std::vector<std::int32_t> winner_ = Map<std::int32_t>();
  SolveTask solve_{};
};

using Loop = void (Scene::*)(const ClosedFormKernels&);

void Kernel(benchmark::State& state, Loop loop, const ClosedFormKernels& kernels) {
  Scene scene;
  testing::OnThreads(1, [&] {
    for (auto _ : state) {
      (scene.*loop)(kernels);
      benchmark::ClobberMemory();
    }
  });
  state.SetItemsProcessed(state.iterations() * Scene::kPixels);
}

/// Every loop beside itself in the other instruction sets.
const bool kRegistered = [] {
  const std::pair<const char*, Loop> loops[] = {
      {"filter_row", &Scene::FilterRow},     {"score_neighbours", &Scene::ScoreNeighbours},
      {"score_shifts", &Scene::ScoreShifts}, {"multiply_row", &Scene::MultiplyRow},
      {"pool_row", &Scene::PoolRow},         {"pool_down", &Scene::PoolDown},
      {"keep_best", &Scene::KeepBest},       {"solve", &Scene::Solve},
      {"smooth_row", &Scene::SmoothRow},     {"smooth_across_rows", &Scene::SmoothAcrossRows}};
  for (const auto& [name, loop] : loops) {
    for (const std::string_view set : UsableKernels()) {
      const ClosedFormKernels& kernels = SelectKernels(set);
      const std::string title = "Kernel/" + std::string(name) + "/" + std::string(set);
      benchmark::RegisterBenchmark(title.c_str(), [loop = loop, &kernels](benchmark::State& s) {
        Kernel(s, loop, kernels);
      })->Unit(benchmark::kMicrosecond);
    }
  }
  return true;
}();

}  // namespace
}  // namespace horopter::vision
