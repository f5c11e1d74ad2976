// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/linear_readout.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <opencv2/core/matx.hpp>
#include <random>
#include <vector>

namespace horopter::vision {
namespace {

using Complex = std::complex<double>;

/// One eye's responses at a pixel.
struct Eye {
  std::vector<float> even, odd;
  SimpleCells cells() const { return {even.data(), odd.data()}; }
  void Add(Complex response) {
    even.push_back(static_cast<float>(response.real()));
    odd.push_back(static_cast<float>(response.imag()));
  }
  Complex at(int i) const { return {even[i], odd[i]}; }
};

struct Eyes {
  Eye left, right;
};

/// What both eyes answer to a stimulus of equal energy in all orientations, displaced by (dx, dy).
Eyes Displaced(const V1Config& config, double dx, double dy) {
  Eyes eyes;
  for (int i = 0; i < config.orientations; ++i) {
    const double theta = OrientationRad(i, config.orientations);
    const double along = dx * std::cos(theta) + dy * std::sin(theta);
    const Complex left = std::polar(0.3, 0.7 * i);
    eyes.left.Add(left);
    eyes.right.Add(left * std::polar(1.0, -2 * M_PI * config.peak_frequency * along));
  }
  return eyes;
}

/// The config with a gain that is unbiased.
V1Config Unbiased() {
  V1Config config = V1Config::Preset("paper_2018");
  config.readout_gain = 1;
  return config;
}

std::vector<float> Sensed(const LinearReadout& readout, const Eyes& eyes) {
  std::vector<float> sums(readout.floats());
  readout.Sense(eyes.left.cells(), eyes.right.cells(), readout.TexturelessEnergy(0), sums.data());
  return sums;
}

PopulationDisparity Decoded(const V1Config& config, const Eyes& eyes) {
  const LinearReadout readout(config);
  return readout.Read(Sensed(readout, eyes).data());
}

TEST(LinearReadout, DecodesEveryDirectionUpToItsLargestPreferredDisparity) {
  const V1Config config = Unbiased();
  for (int direction = 0; direction < 16; ++direction) {
    for (const double length : {0.0, 0.2, 0.38, 0.6, 0.76}) {
      const double dx = length * std::cos(direction * M_PI / 8);
      const double dy = length * std::sin(direction * M_PI / 8);
      const PopulationDisparity decoded = Decoded(config, Displaced(config, dx, dy));
      ASSERT_TRUE(decoded.solved);
      EXPECT_NEAR(decoded.dx, dx, 0.03 + 0.13 * length) << dx << ", " << dy;
      EXPECT_NEAR(decoded.dy, dy, 0.03 + 0.13 * length) << dx << ", " << dy;
    }
  }
}

TEST(LinearReadout, IsUnbiasedAtHalfItsRange) {
  const V1Config config = Unbiased();
  EXPECT_NEAR(Decoded(config, Displaced(config, 0.38, 0)).dx, 0.38, 1e-4);
  EXPECT_NEAR(Decoded(config, Displaced(config, -0.38, 0)).dx, -0.38, 1e-4);
  EXPECT_NEAR(Decoded(config, Displaced(config, 0, 0)).dx, 0, 1e-6);
}

/// The published steps in full: 18 filters over the circle, each with all its phase shifts, divided
/// by their sum over filters, and cells of area MT for two directions, read out linearly.
cv::Vec2d InFull(const V1Config& config, const Eyes& eyes, double gain) {
  const int n = config.orientations;
  std::vector<std::vector<double>> energy(2 * n, std::vector<double>(config.phase_shifts));
  std::vector<double> preferred(config.phase_shifts);
  for (int j = 0; j < config.phase_shifts; ++j) {
    preferred[j] = config.max_disparity_px * (2.0 * j / (config.phase_shifts - 1) - 1);
    const Complex shift = std::polar(1.0, 2 * M_PI * config.peak_frequency * preferred[j]);
    for (int i = 0; i < n; ++i) {
      const Complex left = eyes.left.at(i), right = eyes.right.at(i);
      energy[i][j] = std::pow(std::abs(left + right * shift), config.energy_exponent);
      // The filter turned by pi is the conjugate one.
      energy[n + i][j] =
          std::pow(std::abs(std::conj(left) + std::conj(right) * shift), config.energy_exponent);
    }
  }
  cv::Vec2d decoded(0, 0);
  for (int j = 0; j < config.phase_shifts; ++j) {
    double all = 0;
    for (int i = 0; i < 2 * n; ++i) all += energy[i][j];
    for (int d = 0; d < 2; ++d) {
      double drive = 0;
      for (int i = 0; i < 2 * n; ++i) {
        drive += std::cos(d * M_PI / 2 - i * M_PI / n) * energy[i][j] / all;
      }
      decoded[d] += preferred[j] * std::exp(gain * drive);
    }
  }
  return decoded;
}

TEST(LinearReadout, EqualsThePublishedStepsInFull) {
  const V1Config config = Unbiased();
  // The gain of this form, found where the readout is calibrated.
  const Eyes half = Displaced(config, config.max_disparity_px / 2, 0);
  double low = 0, high = 100;
  for (int step = 0; step < 60; ++step) {
    const double middle = (low + high) / 2;
    (InFull(config, half, middle)[0] < config.max_disparity_px / 2 ? low : high) = middle;
  }
  std::mt19937 random(7);
  std::normal_distribution<double> response(0, 0.3);
  for (int trial = 0; trial < 50; ++trial) {
    Eyes eyes;
    for (int i = 0; i < config.orientations; ++i) {
      eyes.left.Add({response(random), response(random)});
      eyes.right.Add({response(random), response(random)});
    }
    const PopulationDisparity decoded = Decoded(config, eyes);
    const cv::Vec2d expected = InFull(config, eyes, low);
    EXPECT_NEAR(decoded.dx, expected[0], 2e-4);
    EXPECT_NEAR(decoded.dy, expected[1], 2e-4);
  }
}

TEST(LinearReadout, ContrastOfBothEyesDoesNotMoveTheDisparity) {
  const V1Config config = Unbiased();
  Eyes eyes = Displaced(config, 0.4, -0.2);
  const PopulationDisparity before = Decoded(config, eyes);
  for (Eye* eye : {&eyes.left, &eyes.right}) {
    for (float& v : eye->even) v *= 0.25F;
    for (float& v : eye->odd) v *= 0.25F;
  }
  const PopulationDisparity after = Decoded(config, eyes);
  EXPECT_NEAR(after.dx, before.dx, 1e-4);
  EXPECT_NEAR(after.dy, before.dy, 1e-4);
  EXPECT_NEAR(after.correlation, before.correlation, 1e-5);
}

TEST(LinearReadout, GainMultipliesSmallDisparities) {
  V1Config config = Unbiased();
  const double plain = Decoded(config, Displaced(config, 0.1, 0)).dx;
  config.readout_gain = 1.5;
  EXPECT_NEAR(Decoded(config, Displaced(config, 0.1, 0)).dx, 1.5 * plain, 0.01);
}

TEST(LinearReadout, SaysNothingWithoutTextureOrWithTooFewNeighbours) {
  V1Config config = Unbiased();
  config.min_pooled = 0.5;
  const LinearReadout readout(config);
  Eyes eyes = Displaced(config, 0.3, 0);
  std::vector<float> sums = Sensed(readout, eyes);
  const PopulationDisparity whole = readout.Read(sums.data());
  // Pooled with neighbours that have no response: the rest stands for all.
  for (float& v : sums) v *= 0.6F;
  const PopulationDisparity part = readout.Read(sums.data());
  ASSERT_TRUE(part.solved);
  EXPECT_NEAR(part.dx, whole.dx, 1e-5);
  for (float& v : sums) v *= 0.6F;
  EXPECT_FALSE(readout.Read(sums.data()).solved);

  for (Eye* eye : {&eyes.left, &eyes.right}) {
    for (float& v : eye->even) v *= 1e-3F;
    for (float& v : eye->odd) v *= 1e-3F;
  }
  EXPECT_EQ(Sensed(readout, eyes), std::vector<float>(readout.floats(), 0.0F));
  EXPECT_FALSE(Decoded(config, eyes).solved);
}

TEST(LinearReadout, AWholeNeighbourhoodIsWholeInSpiteOfRounding) {
  const V1Config config = V1Config::Preset("paper_2018");
  const LinearReadout readout(config);
  std::vector<float> sums = Sensed(readout, Displaced(config, 0.3, 0));
  for (float& v : sums) v *= 0.99999F;
  EXPECT_TRUE(readout.Read(sums.data()).solved);
  for (float& v : sums) v *= 0.99F;
  EXPECT_FALSE(readout.Read(sums.data()).solved);
}

}  // namespace
}  // namespace horopter::vision
