// SPDX-License-Identifier: Apache-2.0
#include "sim/textures/paint.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <string>

#include "hardware/types/config_error.h"

namespace horopter::sim {
namespace {

constexpr Surface kSquareMetre{1, 1};

TextureRecipe Recipe(const std::string& kind) { return {kind, {1, 1}, {}}; }

cv::Mat PaintSquare(const std::string& kind, std::uint64_t seed, int edge_px = 256) {
  return Paint(Recipe(kind), kSquareMetre, seed, edge_px, edge_px);
}

double GreyDeviation(const cv::Mat& bgr) {
  cv::Mat grey;
  cv::cvtColor(bgr, grey, cv::COLOR_BGR2GRAY);
  cv::Scalar mean, deviation;
  cv::meanStdDev(grey, mean, deviation);
  return deviation[0];
}

class EveryRecipe : public testing::TestWithParam<std::string> {};
class RichRecipe : public EveryRecipe {};

TEST_P(EveryRecipe, SameSeedPaintsTheSameOnAnyNumberOfThreads) {
  const int threads = cv::getNumThreads();
  cv::setNumThreads(1);
  const cv::Mat alone = PaintSquare(GetParam(), 4);
  cv::setNumThreads(3);
  const cv::Mat together = PaintSquare(GetParam(), 4);
  cv::setNumThreads(threads);
  EXPECT_EQ(cv::norm(alone, together, cv::NORM_INF), 0);
}

TEST_P(EveryRecipe, AnotherSeedPaintsSomethingElse) {
  const double difference =
      cv::norm(PaintSquare(GetParam(), 1), PaintSquare(GetParam(), 2), cv::NORM_INF);
  if (GetParam() == "chessboard") {
    EXPECT_EQ(difference, 0);  // a calibration target has no luck
  } else {
    EXPECT_GT(difference, 0);
  }
}

TEST_P(EveryRecipe, ResolutionChangesSharpnessOnly) {
  const cv::Mat fine = PaintSquare(GetParam(), 3, 512);
  const cv::Mat coarse = PaintSquare(GetParam(), 3, 256);
  cv::Mat fine_blurred, coarse_blurred;
  cv::resize(fine, fine_blurred, {32, 32}, 0, 0, cv::INTER_AREA);
  cv::resize(coarse, coarse_blurred, {32, 32}, 0, 0, cv::INTER_AREA);
  EXPECT_LT(cv::norm(fine_blurred, coarse_blurred, cv::NORM_L1) / (32 * 32 * 3),
            8);  // fine print aliases
}

/// 4 mm to 32 mm per sample: what a pixel covers from 1 m to 8 m away at 320x240.
TEST_P(RichRecipe, HasContrastAtEveryViewingDistance) {
  cv::Mat image = PaintSquare(GetParam(), 5);
  for (int edge_px = 256; edge_px >= 32; edge_px /= 2) {
    cv::resize(image, image, {edge_px, edge_px}, 0, 0, cv::INTER_AREA);
    cv::Mat next;
    cv::resize(image, next, {edge_px / 2, edge_px / 2}, 0, 0, cv::INTER_AREA);
    cv::resize(next, next, {edge_px, edge_px}, 0, 0, cv::INTER_NEAREST);
    cv::Mat detail;
    cv::absdiff(image, next, detail);  // what is lost when stepping back to twice the distance
    const cv::Scalar mean = cv::mean(detail);
    EXPECT_GT((mean[0] + mean[1] + mean[2]) / 3, 0.8) << edge_px;
  }
}

INSTANTIATE_TEST_SUITE_P(Recipes, EveryRecipe, testing::ValuesIn(RecipeNames()),
                         [](const auto& info) { return info.param; });

/// All that are not meant to be plain.
std::vector<std::string> RichRecipes() {
  std::vector<std::string> names = RecipeNames();
  std::erase(names, "plain_wall");
  return names;
}

INSTANTIATE_TEST_SUITE_P(Recipes, RichRecipe, testing::ValuesIn(RichRecipes()),
                         [](const auto& info) { return info.param; });

TEST(Paint, PlainWallIsAlmostUniform) { EXPECT_LT(GreyDeviation(PaintSquare("plain_wall", 1)), 2); }

TEST(Paint, RedPaintIsRed) {
  const cv::Mat image = PaintSquare("red_paint", 1);
  int red = 0;
  for (const cv::Vec3b& p : cv::Mat3b(image)) red += p[2] > 1.5 * p[1] && p[2] > 1.5 * p[0];
  EXPECT_GT(red, 0.8 * image.total());
}

TEST(Paint, ChessboardSquaresAreExact) {
  const Surface board{512 * 0.04 / 48, 512 * 0.04 / 56};
  const cv::Mat image = Paint(Recipe("chessboard"), board, 1, 512, 512);
  for (int row = 0; row < 512; ++row) {
    for (int column = 0; column < 512; ++column) {
      const int x = column - 40, y = row - 60;
      const bool inside = x >= 0 && y >= 0 && x < 9 * 48 && y < 7 * 56;
      const bool black = inside && (x / 48 + y / 56) % 2 == 0;
      ASSERT_EQ(image.at<cv::Vec3b>(row, column)[0] < 128, black) << row << ", " << column;
    }
  }
}

TEST(Paint, CarpetTilesWithoutASeam) {
  const cv::Mat image = PaintSquare("carpet", 2);
  const double across = cv::norm(image.col(0), image.col(255), cv::NORM_L1);
  double inside = 0;
  for (int c = 100; c < 110; ++c) {
    inside = std::max(inside, cv::norm(image.col(c), image.col(c + 1), cv::NORM_L1));
  }
  EXPECT_LT(across, 1.5 * inside);
}

TEST(Paint, RefusesASizeThatIsNotPositive) {
  EXPECT_THROW(Paint(Recipe("wood"), kSquareMetre, 1, 0, 8), hardware::ConfigError);
  EXPECT_THROW(Paint(Recipe("wood"), kSquareMetre, 1, 8, -1), hardware::ConfigError);
}

}  // namespace
}  // namespace horopter::sim
