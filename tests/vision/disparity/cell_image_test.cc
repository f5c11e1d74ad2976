// SPDX-License-Identifier: Apache-2.0
// The linear stage of the closed form is that of the population form, in bytes.
#include "vision/disparity/cell_image.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <opencv2/core.hpp>
#include <vector>

#include "kernel_test.h"
#include "random_cells.h"
#include "textured_pair.h"
#include "vision/disparity/edge_map.h"
#include "vision/disparity/gabor_bank.h"

namespace horopter::vision {
namespace {

const cv::Size kSize(61, 47);

/// The bank of the published model, for both forms.
ClosedFormConfig PublishedBank() {
  const V1Config published;
  ClosedFormConfig config;
  config.orientations = kOrientations;
  config.filter_px = published.filter_px;
  config.peak_frequency = published.peak_frequency;
  config.envelope_sigma_px = published.envelope_sigma_px;
  return config;
}

V1Config AsPopulation(const ClosedFormConfig& config) {
  V1Config same;
  same.orientations = config.orientations;
  same.filter_px = config.filter_px;
  same.peak_frequency = config.peak_frequency;
  same.envelope_sigma_px = config.envelope_sigma_px;
  return same;
}

std::complex<double> Response(const SimpleCells& cells, int orientation) {
  return {cells.even[orientation], cells.odd[orientation]};
}

/// A response divided as the closed form does it, before the cell's power is.
std::complex<double> Normalised(std::complex<double> response, double saturation_grey) {
  return response / std::sqrt(std::norm(response) + saturation_grey * saturation_grey / 8);
}

cv::Mat1f Texture(std::uint64_t seed) {
  cv::Mat1f grey;
  testing::ShiftedPair(kSize, 0, 0, seed).left.convertTo(grey, CV_32F);
  return grey;
}

CellImage Packed(const ClosedFormConfig& config, const cv::Mat1f& grey,
                 const ClosedFormKernels& kernels) {
  PaddedMap<float> padded;
  padded.Resize(grey.cols, grey.rows);
  std::copy_n(grey.ptr<float>(), grey.total(), padded.data());
  CellImage cells;
  CellBank(config).Apply(kernels, padded.data(), grey.cols, grey.rows, cells);
  return cells;
}

/// The filters of some parameters, by the code of both forms.
class CellBankKernels : public testing::KernelTest {
 protected:
  void ExpectNormalisedResponses(const ClosedFormConfig& config, const cv::Mat1f& grey) const;
};

INSTANTIATE_TEST_SUITE_P(All, CellBankKernels, testing::EveryKernel(), testing::NameOf);

/// A byte is half a step off, and float's rounding may choose the other.
void CellBankKernels::ExpectNormalisedResponses(const ClosedFormConfig& config,
                                                const cv::Mat1f& grey) const {
  const CellImage cells = Packed(config, grey, kernels_);
  const SimpleCellMap responses = GaborBank(AsPopulation(config)).Apply(grey);
  for (int y = 0; y < grey.rows; ++y) {
    for (int x = 0; x < grey.cols; ++x) {
      double power = 0.02 * config.orientations;
      for (int o = 0; o < config.orientations; ++o) {
        power += std::norm(Normalised(Response(responses.row(y)[x], o), config.saturation_grey));
      }
      const double gain = kCellOne * std::sqrt(kCellPower / power);
      for (int o = 0; o < config.orientations; ++o) {
        const auto expected =
            gain * Normalised(Response(responses.row(y)[x], o), config.saturation_grey);
        const auto found = testing::Response(cells.view(), x, y, o);
        ASSERT_NEAR(found.real(), std::clamp(expected.real(), -127.0, 127.0), 0.6) << x << " " << y;
        ASSERT_NEAR(found.imag(), std::clamp(expected.imag(), -127.0, 127.0), 0.6) << x << " " << y;
      }
      for (int o = config.orientations; o < kMaxCellOrientations; ++o) {
        ASSERT_EQ(testing::Response(cells.view(), x, y, o), 0.0);
      }
    }
  }
}

TEST_P(CellBankKernels, CellsAreTheGaborBanksResponsesNormalised) {
  ClosedFormConfig coarse;
  coarse.orientations = 4;
  coarse.filter_px = 15;
  for (const ClosedFormConfig& config : {PublishedBank(), ClosedFormConfig(), coarse}) {
    ExpectNormalisedResponses(config, Texture(3));
    ExpectNormalisedResponses(config, Texture(3)(cv::Rect(0, 0, 5, 3)).clone());
  }
}

/// Scores have room for the power that a cell can have, and no more: kCellPower, and half a step of
/// rounding in each byte.
TEST_P(CellBankKernels, NoCellHasMorePowerThanItShould) {
  cv::Mat1f black_and_white(kSize);
  cv::RNG random(4);
  for (float& grey : black_and_white) grey = random.uniform(0, 2) == 0 ? 0.0F : 255.0F;
  cv::Mat1f stripes(kSize);
  for (int x = 0; x < kSize.width; ++x) stripes.col(x) = x % 4 < 2 ? 0.0F : 255.0F;
  for (const ClosedFormConfig& config : {PublishedBank(), ClosedFormConfig()}) {
    for (const cv::Mat1f& grey : {black_and_white, stripes}) {
      const CellImage cells = Packed(config, grey, kernels_);
      const double largest =
          kCellOne * std::sqrt(kCellPower) + 0.5 * std::sqrt(2 * config.orientations);
      double most = 0;
      for (int pixel = 0; pixel < kSize.area(); ++pixel) {
        double power = 0;
        for (int i = 0; i < kLanes; ++i) power += std::pow(cells.view().at(pixel)[i], 2);
        most = std::max(most, std::sqrt(power));
        ASSERT_GE(*std::min_element(cells.view().at(pixel), cells.view().at(pixel) + kLanes), -127);
      }
      EXPECT_LE(most, largest);
      EXPECT_GT(most, 0.9 * largest);
      EXPECT_LT(largest * largest * kCellOne / (1 << kScoreShift), 32767 - 16384);
    }
  }
}

TEST(EdgeMap, SumsTheChannelsDifferencesToTheLeftAndAbove) {
  cv::Mat3b colour(2, 3, cv::Vec3b(10, 20, 30));
  colour(0, 1) = {12, 17, 30};
  colour(1, 2) = {255, 255, 255};
  EdgeMap edges;
  FindEdges(colour, 0, edges);
  EXPECT_EQ(std::vector<int>(edges.x.data(), edges.x.data() + 6),
            (std::vector<int>{0, 5, 5, 0, 0, 255}));
  EXPECT_EQ(std::vector<int>(edges.y.data(), edges.y.data() + 6),
            (std::vector<int>{0, 0, 0, 0, 5, 255}));
}

TEST(PoolingWeights, FallWithDistanceAndColour) {
  const PoolingWeights weights = MakePoolingWeights(4, 20);
  EXPECT_NEAR(weights[0] / 32768.0, std::exp(-std::sqrt(2) / 4), 1e-4);
  // A step of colour_grey counts as much as deviation_px pixels.
  EXPECT_NEAR(weights[20] / 32768.0, std::exp(-std::sqrt(2) / 4 * 5), 1e-4);
  EXPECT_TRUE(std::is_sorted(weights.rbegin(), weights.rend()));
}

TEST(PoolRow, KeepsAConstantAndStopsAtAnEdge) {
  constexpr int kWidth = 40, kEdge = 25;
  std::vector<std::int16_t> row(kWidth * kLanes);
  std::vector<std::uint8_t> edges(kWidth, 0);
  edges[kEdge] = 255;
  for (int x = 0; x < kWidth; ++x) {
    for (int k = 0; k < kLanes; ++k) {
      row[x * kLanes + k] = static_cast<std::int16_t>(x < kEdge ? 1000 : -500);
    }
  }
  SelectKernels().pool_row(row.data(), edges.data(), MakePoolingWeights(4, 20), kWidth);
  for (int x = 0; x < kWidth; ++x)
    EXPECT_NEAR(row[x * kLanes + 5], x < kEdge ? 1000 : -500, 2) << x;
}

}  // namespace
}  // namespace horopter::vision
