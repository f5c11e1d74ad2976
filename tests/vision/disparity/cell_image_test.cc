// SPDX-License-Identifier: Apache-2.0
// Where the mathematics says that the closed form equals the population form, it does.
#include "vision/disparity/cell_image.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <opencv2/core.hpp>
#include <vector>

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

CellImage Packed(const ClosedFormConfig& config, const cv::Mat1f& grey) {
  PaddedMap<float> padded;
  padded.Resize(grey.cols, grey.rows);
  std::copy_n(grey.ptr<float>(), grey.total(), padded.data());
  CellImage cells;
  CellBank(config).Apply(SelectKernels(), padded.data(), grey.cols, grey.rows, cells);
  return cells;
}

TEST(ClosedForm, OneProductHoldsTheEnergyAtEveryPhaseShift) {
  const SimpleCellMap left = GaborBank(V1Config()).Apply(Texture(1));
  const SimpleCellMap right = GaborBank(V1Config()).Apply(Texture(2));
  for (int y = 0; y < kSize.height; y += 5) {
    for (int x = 0; x < kSize.width; x += 5) {
      for (int o = 0; o < kOrientations; ++o) {
        const auto l = Response(left.row(y)[x], o), r = Response(right.row(y)[x], o);
        const auto product = l * std::conj(r);
        for (int j = 0; j < kPhaseShifts; ++j) {
          const double phase = 2 * M_PI * 0.25 * (-1.5 + 0.5 * j);
          const double population = std::norm(l + r * std::polar(1.0, phase));
          const double closed = std::norm(l) + std::norm(r) +
                                2 * std::abs(product) * std::cos(std::arg(product) - phase);
          EXPECT_NEAR(closed, population, 1e-9 * (1 + population));
        }
      }
    }
  }
}

TEST(ClosedForm, ItsPhaseIsWhatALinearDecodingOfSquaredEnergiesGives) {
  // Sum over equally spaced shifts of energy^2 exp(i shift): the mean drops out, and what is left
  // points to the shift that agrees best.
  const SimpleCellMap left = GaborBank(V1Config()).Apply(Texture(1));
  const SimpleCellMap right = GaborBank(V1Config()).Apply(Texture(2));
  constexpr int kShifts = 7;
  for (int x = 0; x < kSize.width; x += 3) {
    const auto l = Response(left.row(20)[x], 3), r = Response(right.row(20)[x], 3);
    std::complex<double> decoded = 0;
    for (int j = 0; j < kShifts; ++j) {
      const double phase = 2 * M_PI * j / kShifts;
      decoded += std::norm(l + r * std::polar(1.0, phase)) * std::polar(1.0, phase);
    }
    EXPECT_NEAR(std::arg(decoded / (l * std::conj(r))), 0, 1e-6);
  }
}

TEST(CellBank, CellsAreThePublishedBanksResponsesNormalised) {
  const ClosedFormConfig config = PublishedBank();
  const cv::Mat1f grey = Texture(3);
  const CellImage cells = Packed(config, grey);
  const SimpleCellMap responses = GaborBank(V1Config()).Apply(grey);
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) {
      double power = 0.02 * kOrientations;
      for (int o = 0; o < kOrientations; ++o) {
        power += std::norm(Normalised(Response(responses.row(y)[x], o), config.saturation_grey));
      }
      const double gain = kCellOne * std::sqrt(kCellPower / power);
      const std::int8_t* cell = cells.view().at(y * kSize.width + x);
      for (int o = 0; o < kOrientations; ++o) {
        const auto expected =
            gain * Normalised(Response(responses.row(y)[x], o), config.saturation_grey);
        ASSERT_NEAR(cell[o], std::clamp(expected.real(), -127.0, 127.0), 0.6) << x << " " << y;
        ASSERT_NEAR(cell[kMaxCellOrientations + o], std::clamp(expected.imag(), -127.0, 127.0),
                    0.6);
      }
    }
  }
}

TEST(CellBank, ScoresAreTheCorrelationOfCells) {
  const ClosedFormConfig config;
  const CellImage left = Packed(config, Texture(1)), right = Packed(config, Texture(2));
  const CellBank bank(config);
  std::vector<std::int16_t> hypothesis_x(kSize.area() + 16), hypothesis_y(kSize.area() + 16);
  std::vector<std::int16_t> scores(static_cast<std::size_t>(kSize.area()) * kLanes);
  Candidates candidates{};
  for (int k = 0; k < kLanes; ++k) candidates.move_x[k] = (k - 8) * kHypothesisSteps;  // whole px
  const NeighbourTask task{left.view(),    right.view(), hypothesis_x.data(), hypothesis_y.data(),
                           &bank.tables(), &candidates,  scores.data()};
  const int y = 20;
  SelectKernels().score_neighbours(task, y);
  for (int x = 0; x < kSize.width; ++x) {
    for (int k = 0; k < kLanes; ++k) {
      const int match = x + k - 8;
      double sum = 0;
      for (int i = 0; i < kLanes && match >= 0 && match < kSize.width; ++i) {
        sum += left.view().at(y * kSize.width + x)[i] * right.view().at(y * kSize.width + match)[i];
      }
      const double one = kCellPower * kCellOne * kCellOne;
      EXPECT_NEAR(scores[(y * kSize.width + x) * kLanes + k] / kScoreOne, sum / one, 1e-3);
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
