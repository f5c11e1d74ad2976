// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/gabor_bank.h"

#include <gtest/gtest.h>

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
  const double theta = OrientationRad(orientation);
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

TEST(GaborBank, SeparableFiltersEqualTheirFormula) {
  const V1Config config;
  cv::RNG rng(3);
  cv::Mat1f image(23, 31);
  rng.fill(image, cv::RNG::UNIFORM, 0, 255);
  const SimpleCellMap cells = GaborBank(config).Apply(image);
  for (int i = 0; i < kOrientations; ++i) {
    for (const cv::Point p :
         {cv::Point(15, 11), cv::Point(0, 0), cv::Point(30, 22), cv::Point(2, 20)}) {
      const Complex expected = Direct(image, p.x, p.y, i, config);
      EXPECT_LT(std::abs(Response(cells.row(p.y)[p.x], i) - expected), 1e-3)
          << "orientation " << i << " at " << p;
    }
  }
}

TEST(GaborBank, ConstantImageGivesNothing) {
  const SimpleCellMap cells = GaborBank(V1Config()).Apply(cv::Mat1f(20, 20, 255.0F));
  for (int i = 0; i < kOrientations; ++i) {
    EXPECT_LT(std::abs(Response(cells.row(10)[10], i)), 1e-3);
    EXPECT_LT(std::abs(Response(cells.row(0)[19], i)), 1e-3);
  }
}

TEST(GaborBank, EachOrientationAnswersMostToItsOwnWaveWithHalfTheAmplitude) {
  const V1Config config;
  const GaborBank bank(config);
  for (int wave = 0; wave < kOrientations; ++wave) {
    const double k = 2 * CV_PI * config.peak_frequency;
    const SimpleCellMap cells = bank.Apply(
        Wave({41, 41}, k * std::cos(OrientationRad(wave)), k * std::sin(OrientationRad(wave))));
    const double own = std::abs(Response(cells.row(20)[20], wave));
    EXPECT_NEAR(own, 25, 1) << "orientation " << wave;
    for (int i = 0; i < kOrientations; ++i) {
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

TEST(SimpleCellMap, InterpolatesLinearlyUpToTheLastPixel) {
  SimpleCellMap map({3, 2});
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 3; ++x) {
      for (int i = 0; i < kOrientations; ++i) {
        map.row(y)[x].even[i] = static_cast<float>(x + 10 * y + 100 * i);
        map.row(y)[x].odd[i] = -map.row(y)[x].even[i];
      }
    }
  }
  EXPECT_NEAR(map.At(1.25F, 0.5F).even[2], 1.25 + 5 + 200, 1e-4);
  EXPECT_NEAR(map.At(1.25F, 0.5F).odd[2], -206.25, 1e-4);
  EXPECT_FLOAT_EQ(map.At(2, 1).even[7], 2 + 10 + 700);
}

}  // namespace
}  // namespace horopter::vision
