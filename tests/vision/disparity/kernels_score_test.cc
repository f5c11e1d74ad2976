// SPDX-License-Identifier: Apache-2.0
// Scores of hypotheses, of every instruction set, against the correlation of cells in double.
#include "vision/disparity/closed_form_kernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include "kernel_test.h"
#include "random_cells.h"

namespace horopter::vision {
namespace {

using testing::RandomCells;
using testing::Response;
using testing::Turn;

/// Wider than the blocks of kColumnsAtOnce, and a multiple of nothing.
const cv::Size kSize(83, 13);
const std::size_t kPixels = static_cast<std::size_t>(kSize.area());

using Scores = std::vector<std::int16_t>;

class ScoreKernels : public testing::KernelTest {
 protected:
  ScoreKernels() {
    cv::RNG random(5);
    for (std::size_t i = 0; i < kPixels; ++i) {
      hypothesis_x_[i] = static_cast<std::int16_t>(random.uniform(-100, 100));
      hypothesis_y_[i] = static_cast<std::int16_t>(random.uniform(-60, 60));
    }
  }

  Scores Neighbours(const CellView& left, const CellView& right, const Candidates& candidates) {
    Scores scores(kPixels * kLanes, -1);
    const NeighbourTask task{
        left,        right,        hypothesis_x_.data(), hypothesis_y_.data(), &bank_.tables(),
        &candidates, scores.data()};
    for (int y = 0; y < kSize.height; ++y) kernels_.score_neighbours(task, y);
    return scores;
  }

  Scores Shifts(const CellView& left, const CellView& right, int first_dx, int move_y) {
    Scores scores(kPixels * kLanes, -1);
    const ShiftTask task{left,     right,  hypothesis_y_.data(), &bank_.tables(),
                         first_dx, move_y, scores.data()};
    for (int y = 0; y < kSize.height; ++y) kernels_.score_shifts(task, y);
    return scores;
  }

  /// The correlation of a cell with the one at (x, y) [px], taken from the nearest pixel.
  struct Correlation {
    double score = 0;
    double tolerance = 1;  ///< a table's bytes are off by half a step in each part; and the shift
  };
  Correlation Correlate(const CellView& left, int left_x, int left_y, const CellView& right,
                        double x, double y) const {
    const int px = static_cast<int>(std::floor(x + 0.5)),
              py = static_cast<int>(std::floor(y + 0.5));
    Correlation out;
    if (px < 0 || px >= kSize.width || py < 0 || py >= kSize.height) return out;
    constexpr double kUnit = 1 << kScoreShift;
    for (int o = 0; o < bank_.orientations(); ++o) {
      const auto l = Response(left, left_x, left_y, o), r = Response(right, px, py, o);
      out.score += kCellOne / kUnit * (l * std::conj(r * Turn(bank_, o, x - px, y - py))).real();
      out.tolerance += std::sqrt(0.5) / kUnit * std::abs(l) * std::abs(r);
    }
    return out;
  }

  CellBank bank_{ClosedFormConfig()};
  CellImage left_ = RandomCells(kSize, bank_.orientations(), 1);
  CellImage right_ = RandomCells(kSize, bank_.orientations(), 2);
  std::vector<std::int16_t> hypothesis_x_ = std::vector<std::int16_t>(kPixels + 16);
  std::vector<std::int16_t> hypothesis_y_ = std::vector<std::int16_t>(kPixels + 16);
};

INSTANTIATE_TEST_SUITE_P(All, ScoreKernels, testing::EveryKernel(), testing::NameOf);

/// Hypotheses of neighbours up to 44 px away, each moved by sixteenths of a pixel.
Candidates SomeCandidates() {
  return {.from_x = {0, 1, -1, 0, 0, 4, -4, 0, 0, 44, -44, 0, 0, 3, -70, 90},
          .from_y = {0, 0, 0, 1, -1, 0, 0, 4, -4, 0, 0, 44, -44, 2, -9, 11},
          .move_x = {0, 1, -1, 7, -7, 8, -8, 9, -9, 15, -15, 16, -16, 31, -33, 5},
          .move_y = {0, 0, 3, -3, 8, -8, 7, -7, 9, -9, 1, -1, 16, -16, 5, 32}};
}

TEST_P(ScoreKernels, NeighboursAreCorrelatedBetweenPixels) {
  const Candidates candidates = SomeCandidates();
  const Scores scores = Neighbours(left_.view(), right_.view(), candidates);
  int outside = 0, between = 0;
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) {
      for (int k = 0; k < kLanes; ++k) {
        const int from = std::clamp(y + candidates.from_y[k], 0, kSize.height - 1) * kSize.width +
                         std::clamp(x + candidates.from_x[k], 0, kSize.width - 1);
        const int dx = hypothesis_x_[from] + candidates.move_x[k];
        const int dy = hypothesis_y_[from] + candidates.move_y[k];
        const Correlation expected =
            Correlate(left_.view(), x, y, right_.view(), x + dx / 16.0, y + dy / 16.0);
        outside += expected.tolerance == 1 ? 1 : 0;
        between += dx % kHypothesisSteps != 0 && dy % kHypothesisSteps != 0 ? 1 : 0;
        ASSERT_NEAR(scores[(y * kSize.width + x) * kLanes + k], expected.score, expected.tolerance)
            << x << " " << y << " lane " << k << ": " << dx << "/16 " << dy << "/16";
      }
    }
  }
  EXPECT_GT(outside, 1000);
  EXPECT_GT(between, 10000);
}

/// The left cell turned back is the right cell turned: the sums have the same terms.
TEST_P(ScoreKernels, ShiftsHaveTheScoresOfTheSameHypotheses) {
  std::fill(hypothesis_x_.begin(), hypothesis_x_.end(), std::int16_t{0});
  for (const int first_dx : {-90, -20, -7, 0, 9, 70}) {
    for (const int move_y : {-16, 0, 5, 16}) {
      Candidates candidates{};
      for (int k = 0; k < kLanes; ++k) {
        candidates.move_x[k] = (first_dx + k) * kHypothesisSteps;
        candidates.move_y[k] = move_y;
      }
      EXPECT_EQ(Shifts(left_.view(), right_.view(), first_dx, move_y),
                Neighbours(left_.view(), right_.view(), candidates))
          << first_dx << " " << move_y;
    }
  }
}

TEST_P(ScoreKernels, ShiftsWithoutAFieldStayOnTheRow) {
  Scores scores(kPixels * kLanes, -1);
  const ShiftTask task{left_.view(), right_.view(), nullptr, &bank_.tables(), -3, 0, scores.data()};
  for (int y = 0; y < kSize.height; ++y) kernels_.score_shifts(task, y);
  std::fill(hypothesis_y_.begin(), hypothesis_y_.end(), std::int16_t{0});
  EXPECT_EQ(scores, Shifts(left_.view(), right_.view(), -3, 0));
}

/// Equal cells of all the power there is, and opposite ones: the largest scores.
TEST_P(ScoreKernels, TheLargestScoresFit) {
  CellImage opposite = RandomCells(kSize, bank_.orientations(), 1);
  for (std::size_t i = 0; i < kPixels * kLanes; ++i) {
    opposite.data()[i] = static_cast<std::int8_t>(-opposite.data()[i]);
  }
  std::fill(hypothesis_x_.begin(), hypothesis_x_.end(), std::int16_t{0});
  std::fill(hypothesis_y_.begin(), hypothesis_y_.end(), std::int16_t{0});
  const Scores equal = Neighbours(left_.view(), left_.view(), {});
  const Scores negative = Neighbours(left_.view(), opposite.view(), {});
  double largest = 0;
  for (std::size_t i = 0; i < equal.size(); ++i) {
    const int x = static_cast<int>(i / kLanes) % kSize.width;
    const int y = static_cast<int>(i / kLanes) / kSize.width;
    const Correlation one = Correlate(left_.view(), x, y, left_.view(), x, y);
    largest = std::max(largest, one.score);
    ASSERT_NEAR(equal[i], one.score, 1);
    ASSERT_NEAR(negative[i], -one.score, 1);
  }
  EXPECT_GT(largest, 0.99 * kScoreOne);
}

}  // namespace
}  // namespace horopter::vision
