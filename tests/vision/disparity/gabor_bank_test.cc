// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/gabor_bank.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <opencv2/core.hpp>

namespace horopter::vision {
namespace {

using Complex = std::complex<double>;

Complex Response(const SimpleCells& cells, int i) { return {cells.even[i], cells.odd[i]}; }

cv::Mat1f Wave(cv::Size size, double kx, double ky) {
  cv::Mat1f image(size);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      image(y, x) = static_cast<float>(128 + 50 * std::cos(kx * x + ky * y));
    }
  }
  return image;
}

/// The filter as its formula says, as a double sum over the image.
Complex Direct(const cv::Mat1f& image, int x, int y, int orientation, const V1Config& config) {
  const int radius = config.filter_px / 2;
  const double theta = OrientationRad(orientation, config.orientations);
  Complex sum = 0, wave_sum = 0, image_sum = 0;
  double envelope_sum = 0;
  for (int v = -radius; v <= radius; ++v) {
    for (int u = -radius; u <= radius; ++u) {
      const double sigma = config.envelope_sigma_px;
      const double envelope = std::exp(-(u * u + v * v) / (2 * sigma * sigma));
      const double phase =
          2 * CV_PI * config.peak_frequency * (u * std::cos(theta) + v * std::sin(theta));
      const double grey =
          image(std::clamp(y + v, 0, image.rows - 1), std::clamp(x + u, 0, image.cols - 1));
      sum += envelope * std::polar(1.0, -phase) * grey;
      wave_sum += envelope * std::polar(1.0, -phase);
      image_sum += envelope * grey;
      envelope_sum += envelope;
    }
  }
  return (sum - wave_sum.real() / envelope_sum * image_sum) / envelope_sum;
}

class EveryBank : public ::testing::TestWithParam<const char*> {
 protected:
  const V1Config config_ = V1Config::Preset(GetParam());
};

INSTANTIATE_TEST_SUITE_P(GaborBank, EveryBank, ::testing::Values("paper_2009", "paper_2018"));

TEST_P(EveryBank, SeparableFiltersEqualTheirFormula) {
  cv::RNG rng(3);
  cv::Mat1f image(23, 31);
  rng.fill(image, cv::RNG::UNIFORM, 0, 255);
  const SimpleCellMap cells = GaborBank(config_).Apply(image);
  ASSERT_EQ(cells.orientations(), config_.orientations);
  for (int i = 0; i < config_.orientations; ++i) {
    for (const cv::Point p :
         {cv::Point(15, 11), cv::Point(0, 0), cv::Point(30, 22), cv::Point(2, 20)}) {
      const Complex expected = Direct(image, p.x, p.y, i, config_);
      EXPECT_LT(std::abs(Response(cells.row(p.y)[p.x], i) - expected), 1e-3)
          << "orientation " << i << " at " << p;
    }
  }
}

TEST(GaborBank, Of2018HasNineOrientationsTwentyDegreesApart) {
  const V1Config config = V1Config::Preset("paper_2018");
  EXPECT_EQ(config.orientations, 9);
  for (int i = 0; i < 9; ++i) {
    EXPECT_NEAR(OrientationRad(i, config.orientations), i * CV_PI / 9, 1e-12);
  }
}

TEST(GaborBank, ConstantImageGivesNothing) {
  const SimpleCellMap cells = GaborBank(V1Config()).Apply(cv::Mat1f(20, 20, 255.0F));
  for (int i = 0; i < kOrientations; ++i) {
    EXPECT_LT(std::abs(Response(cells.row(10)[10], i)), 1e-3);
    EXPECT_LT(std::abs(Response(cells.row(0)[19], i)), 1e-3);
  }
}

TEST_P(EveryBank, EachOrientationAnswersMostToItsOwnWaveWithHalfTheAmplitude) {
  const GaborBank bank(config_);
  const int orientations = config_.orientations;
  for (int wave = 0; wave < orientations; ++wave) {
    const double k = 2 * CV_PI * config_.peak_frequency;
    const double theta = OrientationRad(wave, orientations);
    const SimpleCellMap cells =
        bank.Apply(Wave({41, 41}, k * std::cos(theta), k * std::sin(theta)));
    const double own = std::abs(Response(cells.row(20)[20], wave));
    EXPECT_NEAR(own, 25, 1) << "orientation " << wave;
    for (int i = 0; i < orientations; ++i) {
      if (i == wave) continue;
      EXPECT_LT(std::abs(Response(cells.row(20)[20], i)), own)
          << "wave " << wave << " filter " << i;
    }
  }
}

TEST(GaborBank, PhaseTurnsAsTheImageMoves) {
  const V1Config config;
  const double k = 2 * CV_PI * config.peak_frequency;
  const double shift = 0.4;
  const GaborBank bank(config);
  const SimpleCellMap still = bank.Apply(Wave({41, 41}, k, 0));
  cv::Mat1f moved_image(41, 41);
  for (int y = 0; y < 41; ++y) {
    for (int x = 0; x < 41; ++x) {
      moved_image(y, x) = static_cast<float>(128 + 50 * std::cos(k * (x - shift)));
    }
  }
  const SimpleCellMap moved = bank.Apply(moved_image);
  const Complex turn = Response(still.row(20)[20], 0) * std::conj(Response(moved.row(20)[20], 0));
  EXPECT_NEAR(std::arg(turn), k * shift, 0.02);
}

/// A count with loops of its own, and one without.
class SimpleCellMaps : public ::testing::TestWithParam<int> {};

INSTANTIATE_TEST_SUITE_P(GaborBank, SimpleCellMaps, ::testing::Values(8, 9));

TEST_P(SimpleCellMaps, InterpolateLinearlyUpToTheLastPixel) {
  const int n = GetParam();
  SimpleCellMap map({3, 2}, n);
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 3; ++x) {
      for (int i = 0; i < n; ++i) {
        const auto value = static_cast<float>(x + 10 * y + 100 * i);
        map.data(y)[2 * n * x + i] = value;
        map.data(y)[2 * n * x + n + i] = -value;
      }
    }
  }
  EXPECT_EQ(map.row(1)[2].even[7], 2 + 10 + 700);
  EXPECT_EQ(map.row(1)[2].odd[1], -(2 + 10 + 100));
  std::array<float, 2 * kMaxOrientations> cells;
  map.At(1.25F, 0.5F, cells.data());
  EXPECT_NEAR(cells[2], 1.25 + 5 + 200, 1e-4);
  EXPECT_NEAR(cells[n + 2], -206.25, 1e-4);
  map.At(2, 1, cells.data());
  EXPECT_FLOAT_EQ(cells[7], 2 + 10 + 700);
}

}  // namespace
}  // namespace horopter::vision
