// SPDX-License-Identifier: Apache-2.0
// Pooling and the choice of the best hypothesis, of every instruction set, against plain loops.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <vector>

#include "kernel_test.h"
#include "vision/disparity/closed_form_kernels.h"
#include "vision/disparity/edge_map.h"

namespace horopter::vision {
namespace {

const cv::Size kSize(83, 37);
const std::size_t kPixels = static_cast<std::size_t>(kSize.area());
constexpr int kLargest = 16383;  ///< lanes; twice as much is what a difference has room for

using Lanes = std::vector<std::int16_t>;

class PoolKernels : public testing::KernelTest {
 protected:
  PoolKernels() {
    cv::RNG random(6);
    for (std::size_t i = 0; i < kPixels; ++i) {
      edge_x_[i] = RandomEdge(random);
      edge_y_[i] = RandomEdge(random);
    }
  }
  /// Plain ground, with an edge of some height now and then.
  static std::uint8_t RandomEdge(cv::RNG& random) {
    return static_cast<std::uint8_t>(random.uniform(0, 4) > 0 ? 0 : random.uniform(0, 256));
  }
  static Lanes RandomLanes(int largest, std::uint64_t seed) {
    cv::RNG random(seed);
    Lanes lanes(kPixels * kLanes);
    for (std::int16_t& lane : lanes) {
      lane = static_cast<std::int16_t>(random.uniform(-largest, largest + 1));
    }
    return lanes;
  }
  static std::size_t At(int x, int y) { return static_cast<std::size_t>(y) * kSize.width + x; }

  /// Along rows and down columns, in the strips and blocks of its caller.
  void PoolRowsAndDown(Lanes& lanes) {
    for (int y = 0; y < kSize.height; ++y) {
      kernels_.pool_row(lanes.data() + At(0, y) * kLanes, edge_x_.data() + At(0, y), weights_,
                        kSize.width);
    }
    const ColumnPool pool = Columns(lanes, weights_);
    for (int y = 0; y < kSize.height; y += 16) {
      const int end = std::min(y + 16, kSize.height);
      kernels_.pool_down(pool, y, end, 0, 50);
      kernels_.pool_down(pool, y, end, 50, kSize.width);
    }
  }
  ColumnPool Columns(Lanes& lanes, const PoolingWeights& weights) const {
    return {lanes.data(), kSize.width, kSize.height, edge_y_.data(), &weights};
  }
  /// Right, left, down and up again, one number a pixel, in double.
  std::vector<double> Pooled(const Lanes& lanes, int lane) const {
    std::vector<double> v(kPixels);
    for (std::size_t i = 0; i < kPixels; ++i) v[i] = lanes[i * kLanes + lane];
    const auto mix = [&](std::size_t to, std::size_t from, std::uint8_t edge) {
      v[to] += weights_[edge] / 32768.0 * (v[from] - v[to]);
    };
    for (int y = 0; y < kSize.height; ++y) {
      for (int x = 1; x < kSize.width; ++x) mix(At(x, y), At(x - 1, y), edge_x_[At(x, y)]);
      for (int x = kSize.width - 2; x >= 0; --x) {
        mix(At(x, y), At(x + 1, y), edge_x_[At(x + 1, y)]);
      }
    }
    for (int x = 0; x < kSize.width; ++x) {
      for (int y = 1; y < kSize.height; ++y) mix(At(x, y), At(x, y - 1), edge_y_[At(x, y)]);
      for (int y = kSize.height - 2; y >= 0; --y) {
        mix(At(x, y), At(x, y + 1), edge_y_[At(x, y + 1)]);
      }
    }
    return v;
  }
  void KeepInBlocks(const KeepTask& task) {
    for (int x = 0; x < kSize.width; x += kColumnsAtOnce) {
      kernels_.keep_best(task, x, std::min(x + kColumnsAtOnce, kSize.width));
    }
  }

  PoolingWeights weights_ = MakePoolingWeights(4, 20);
  PoolingWeights unpooled_{};
  std::vector<std::uint8_t> edge_x_ = std::vector<std::uint8_t>(kPixels + 16);
  std::vector<std::uint8_t> edge_y_ = std::vector<std::uint8_t>(kPixels + 16);
  std::vector<std::int16_t> best_ = std::vector<std::int16_t>(kPixels + 16, 77);
  std::vector<std::int32_t> winner_ = std::vector<std::int32_t>(kPixels + 16, 99);
};

INSTANTIATE_TEST_SUITE_P(All, PoolKernels, testing::EveryKernel(), testing::NameOf);

/// Each of four passes rounds by half a unit, and carries on at most the largest weight of it.
TEST_P(PoolKernels, FourPassesAreTheRecursiveFilterUpToTheLargestValues) {
  for (const int largest : {100, 12000, kLargest}) {
    const Lanes lanes = RandomLanes(largest, 7);
    Lanes pooled = lanes;
    PoolRowsAndDown(pooled);
    const KeepTask keep{Columns(pooled, weights_), 1, true, 0, 0, best_.data(), winner_.data()};
    const double tolerance = 4 * 0.5 / (1 - weights_[0] / 32768.0);
    // Each lane in turn is the only one that counts; its score has the way up in it.
    for (int lane = 0; lane < kLanes; ++lane) {
      for (std::size_t i = 0; i < kPixels; ++i) {
        std::swap(pooled[i * kLanes], pooled[i * kLanes + lane]);
      }
      KeepInBlocks(keep);
      const std::vector<double> expected = Pooled(lanes, lane);
      for (std::size_t i = 0; i < kPixels; ++i) {
        ASSERT_NEAR(best_[i], expected[i], tolerance) << "pixel " << i << " lane " << lane;
        ASSERT_EQ(winner_[i], 0);
      }
      for (std::size_t i = 0; i < kPixels; ++i) {
        std::swap(pooled[i * kLanes], pooled[i * kLanes + lane]);
      }
    }
  }
}

/// Neighbours as far apart as may be, and weights that take nearly all of the other.
TEST_P(PoolKernels, TheLargestDifferencesFit) {
  Lanes lanes(kPixels * kLanes);
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    const std::size_t x = i / kLanes % kSize.width, y = i / kLanes / kSize.width;
    lanes[i] = static_cast<std::int16_t>((x + y + i % kLanes) % 2 == 0 ? kLargest : -kLargest);
  }
  for (const std::int16_t weight : {32767, 16384, 1, 0}) {
    weights_.fill(weight);
    Lanes row(lanes.begin(), lanes.begin() + kSize.width * kLanes);
    kernels_.pool_row(row.data(), edge_x_.data(), weights_, kSize.width);
    double forth = lanes[0];
    std::vector<double> expected = {forth};
    for (int x = 1; x < kSize.width; ++x) {
      forth = lanes[x * kLanes] + weight / 32768.0 * (forth - lanes[x * kLanes]);
      expected.push_back(forth);
    }
    for (int x = kSize.width - 2; x >= 0; --x) {
      expected[x] += weight / 32768.0 * (expected[x + 1] - expected[x]);
    }
    const double each = std::min<double>(kSize.width, 1 / (1 - weight / 32768.0));
    for (int x = 0; x < kSize.width; ++x) {
      ASSERT_NEAR(row[x * kLanes], expected[x], 2 * 0.5 * each) << x << " weight " << weight;
    }
  }
}

TEST_P(PoolKernels, SolvePoolsUpwardsLikeKeepBest) {
  // One orientation, whose phase is the quotient of its two lanes: a step along x alone.
  Lanes lanes(kPixels * kLanes);
  cv::RNG random(8);
  for (std::size_t i = 0; i < kPixels; ++i) {
    lanes[i * kLanes] = static_cast<std::int16_t>(random.uniform(6000, 12000));
    lanes[i * kLanes + kMaxCellOrientations] =
        static_cast<std::int16_t>(random.uniform(-6000, 6000));
  }
  const std::vector<double> re = Pooled(lanes, 0), im = Pooled(lanes, kMaxCellOrientations);
  PoolRowsAndDown(lanes);
  std::vector<float> dx(kPixels + 16), dy(kPixels + 16);
  SolveTask task{};
  task.pool = Columns(lanes, weights_);
  task.orientations = 1;
  task.nx = {1};
  task.px_per_rad = 1;
  task.ridge = 0.02F;
  task.max_step_px = 10;
  task.dx = dx.data();
  task.dy = dy.data();
  for (int x = 0; x < kSize.width; x += kColumnsAtOnce) {
    kernels_.solve(task, x, std::min(x + kColumnsAtOnce, kSize.width));
  }
  // Lanes are off by less than 7 of 6000 (above), the angle by 1e-4.
  for (std::size_t i = 0; i < kPixels; ++i) {
    ASSERT_NEAR(dx[i], std::atan2(im[i], re[i]) / 1.02, 2e-3) << i;
    ASSERT_EQ(dy[i], 0);
  }
}

/// What keep_best should do with lanes that are not pooled upwards.
struct Leader {
  int score, number;
};
Leader BestOf(const std::int16_t* lanes, const KeepTask& task) {
  Leader leader{lanes[0] + task.favour_own, task.lane_0};
  for (int k = 1; k < task.lanes; ++k) {
    if (lanes[k] > leader.score) leader = {lanes[k], task.lane_0 + k};
  }
  return leader;
}

TEST_P(PoolKernels, TheBestOfTheLanesThatCountIsKept) {
  for (const int count : {1, 2, 7, 8, 9, 15, 16}) {
    for (const std::int16_t favour : {0, 240}) {
      Lanes lanes = RandomLanes(12000, 9);
      const KeepTask task{
          Columns(lanes, unpooled_), count, true, favour, 32, best_.data(), winner_.data()};
      KeepInBlocks(task);
      for (std::size_t i = 0; i < kPixels; ++i) {
        const Leader expected = BestOf(&lanes[i * kLanes], task);
        ASSERT_EQ(best_[i], expected.score) << "pixel " << i << " of " << count << " lanes";
        ASSERT_EQ(winner_[i], expected.number) << "pixel " << i << " of " << count << " lanes";
      }
    }
  }
  EXPECT_EQ(best_[kPixels], 77) << "written behind the last pixel";
  EXPECT_EQ(winner_[kPixels], 99) << "written behind the last pixel";
}

/// Not even where all that count are as bad as can be, and those that do not perfect.
TEST_P(PoolKernels, LanesThatDoNotCountNeverWin) {
  const auto perfect = static_cast<std::int16_t>(kScoreOne);
  Lanes lanes(kPixels * kLanes, perfect);
  for (std::size_t i = 0; i < kPixels; ++i) {
    std::fill_n(&lanes[i * kLanes], 5, static_cast<std::int16_t>(-perfect));
  }
  KeepInBlocks({Columns(lanes, unpooled_), 5, true, 0, 0, best_.data(), winner_.data()});
  for (std::size_t i = 0; i < kPixels; ++i) {
    ASSERT_EQ(winner_[i], 0);
    ASSERT_EQ(best_[i], -perfect);
  }
}

TEST_P(PoolKernels, OnlyABetterHypothesisReplacesTheBestSoFar) {
  Lanes earlier = RandomLanes(12000, 10), later = RandomLanes(12000, 11);
  // Some pixels are equal: the earlier one stays.
  std::copy_n(earlier.begin(), 200 * kLanes, later.begin());
  const KeepTask first{Columns(earlier, unpooled_), 16, true, 0, 0, best_.data(), winner_.data()};
  const KeepTask second{Columns(later, unpooled_), 11, false, 0, 16, best_.data(), winner_.data()};
  KeepInBlocks(first);
  KeepInBlocks(second);
  int replaced = 0;
  for (std::size_t i = 0; i < kPixels; ++i) {
    const Leader a = BestOf(&earlier[i * kLanes], first), b = BestOf(&later[i * kLanes], second);
    const Leader expected = b.score > a.score ? b : a;
    replaced += b.score > a.score ? 1 : 0;
    ASSERT_EQ(best_[i], expected.score) << i;
    ASSERT_EQ(winner_[i], expected.number) << i;
  }
  EXPECT_GT(replaced, 500);
}

TEST_P(PoolKernels, EqualLanesGoToTheFirst) {
  Lanes lanes(kPixels * kLanes, 400);
  KeepInBlocks({Columns(lanes, unpooled_), 16, true, 0, 48, best_.data(), winner_.data()});
  for (std::size_t i = 0; i < kPixels; ++i) ASSERT_EQ(winner_[i], 48);
}

TEST_P(PoolKernels, ColumnsOutsideTheBlockStay) {
  Lanes lanes = RandomLanes(12000, 12), before = lanes;
  const KeepTask task{Columns(lanes, weights_), 16, true, 0, 0, best_.data(), winner_.data()};
  kernels_.keep_best(task, 3, 20);
  kernels_.keep_best(task, kSize.width - 1, kSize.width);
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) {
      const bool inside = (x >= 3 && x < 20) || x == kSize.width - 1;
      ASSERT_EQ(winner_[At(x, y)] != 99, inside) << x << " " << y;
    }
  }
  EXPECT_EQ(lanes, before) << "the way up is not written back";
  kernels_.pool_down(task.pool, 4, 9, 3, 20);
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) {
      const bool inside = x >= 3 && x < 20 && y >= 4 && y < 9;
      if (inside) continue;
      ASSERT_EQ(lanes[At(x, y) * kLanes], before[At(x, y) * kLanes]) << x << " " << y;
    }
  }
  EXPECT_NE(lanes, before);
}

}  // namespace
}  // namespace horopter::vision
