// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/v1_population.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <random>

namespace horopter::vision {
namespace {

/// Responses of both eyes to a wave packet that holds every orientation, displaced by (dx, dy).
struct Eyes {
  SimpleCells left;
  SimpleCells right;
};

Eyes Displaced(const V1Config& config, double dx, double dy, double magnitude = 20) {
  Eyes eyes;
  for (int i = 0; i < kOrientations; ++i) {
    const double along = dx * std::cos(OrientationRad(i)) + dy * std::sin(OrientationRad(i));
    const std::complex<double> left = std::polar(magnitude, 0.7 * i);
    const std::complex<double> right =
        left * std::polar(1.0, -2 * M_PI * config.peak_frequency * along);
    eyes.left.even[i] = static_cast<float>(left.real());
    eyes.left.odd[i] = static_cast<float>(left.imag());
    eyes.right.even[i] = static_cast<float>(right.real());
    eyes.right.odd[i] = static_cast<float>(right.imag());
  }
  return eyes;
}

PopulationDisparity Decoded(const V1Config& config, const Eyes& eyes) {
  const Population population(config);
  return population.Intersect(
      population.Decode(eyes.left, eyes.right, population.TexturelessEnergy(0)));
}

TEST(Population, DecodesEveryDirectionWithinAStepOfThePhaseGrid) {
  for (const char* preset : {"paper_2009", "checked"}) {
    const V1Config config = V1Config::Preset(preset);
    for (int direction = 0; direction < 16; ++direction) {
      for (const double length : {0.0, 0.3, 0.6, 0.9}) {
        const double dx = length * std::cos(direction * M_PI / 8);
        const double dy = length * std::sin(direction * M_PI / 8);
        const PopulationDisparity decoded = Decoded(config, Displaced(config, dx, dy));
        ASSERT_TRUE(decoded.solved) << preset;
        EXPECT_NEAR(std::hypot(decoded.dx - dx, decoded.dy - dy), 0, 0.15)
            << preset << ' ' << dx << ", " << dy;
      }
    }
  }
}

TEST(Population, PreferredDisparitiesAreDecodedExactly) {
  const V1Config config = V1Config::Preset("paper_2009");
  const PopulationDisparity still = Decoded(config, Displaced(config, 0, 0));
  EXPECT_NEAR(still.dx, 0, 1e-5);
  EXPECT_NEAR(still.dy, 0, 1e-5);
  EXPECT_NEAR(still.correlation, 1, 1e-5);
}

TEST(Population, ContrastOfOneEyeDoesNotMoveTheDisparity) {
  const V1Config config;
  Eyes eyes = Displaced(config, 0.5, -0.3);
  const PopulationDisparity before = Decoded(config, eyes);
  for (int i = 0; i < kOrientations; ++i) {
    eyes.right.even[i] *= 0.5F;
    eyes.right.odd[i] *= 0.5F;
  }
  const PopulationDisparity after = Decoded(config, eyes);
  EXPECT_NEAR(after.dx, before.dx, 0.05);
  EXPECT_NEAR(after.dy, before.dy, 0.05);
}

TEST(Population, EnergyBelowTheNoiseHasNoConstraints) {
  const V1Config config;
  const Population population(config);
  const float noise = population.TexturelessEnergy(0);
  // Over the phases the mean of |1 + exp(i phi)| is 1.40 for equal eyes without disparity.
  const Eyes weak = Displaced(config, 0, 0, 0.9 * noise / 1.40);
  const Eyes strong = Displaced(config, 0, 0, 1.1 * noise / 1.40);
  EXPECT_EQ(population.Decode(weak.left, weak.right, noise).count, 0);
  EXPECT_EQ(population.Decode(strong.left, strong.right, noise).count, kOrientations);
}

TEST(Population, OneDirectionAloneIsAnApertureProblem) {
  const Population population{V1Config()};
  const float d = 0.4F;  // along x, seen by three cells that all measure along x
  Constraints c;
  c.nx_nx = 3;
  c.nx_d = 3 * d;
  c.count = 3;
  c.power = 1;
  EXPECT_FALSE(population.Intersect(c).solved);
  c.ny_ny = 3;  // and by three that measure along y
  const PopulationDisparity solution = population.Intersect(c);
  EXPECT_TRUE(solution.solved);
  EXPECT_NEAR(solution.dx, d, 1e-6);
  EXPECT_NEAR(solution.dy, 0, 1e-6);
}

TEST(Population, FewerOrientationsThanAskedForAreNotSolved) {
  V1Config config;
  config.min_orientation_response = 0.5;
  config.energy_weights = false;
  Eyes eyes = Displaced(config, 0.5, 0);
  for (int i = 0; i < kOrientations; ++i) {
    if (i == 0 || i == kOrientations / 2) continue;  // these two alone see something
    eyes.left.even[i] = eyes.left.odd[i] = eyes.right.even[i] = eyes.right.odd[i] = 0.01F;
  }
  EXPECT_FALSE(Decoded(config, eyes).solved);
  config.min_orientations = 2;
  EXPECT_TRUE(Decoded(config, eyes).solved);
}

TEST(Population, CorrelationIsOneForEqualEyesAndMinusOneForInvertedOnes) {
  const V1Config config;
  Eyes eyes = Displaced(config, 0, 0);
  EXPECT_NEAR(Decoded(config, eyes).correlation, 1, 1e-5);
  for (int i = 0; i < kOrientations; ++i) {
    eyes.right.even[i] = -eyes.right.even[i];
    eyes.right.odd[i] = -eyes.right.odd[i];
  }
  EXPECT_NEAR(Decoded(config, eyes).correlation, -1, 1e-5);
}

TEST(Population, CorrelationOfUnrelatedEyesIsZeroOnAverage) {
  const V1Config config;
  std::mt19937 random(4);
  std::normal_distribution<float> grey(0, 20);
  double sum = 0;
  const int trials = 2000;
  for (int trial = 0; trial < trials; ++trial) {
    Eyes eyes;
    for (SimpleCells* cells : {&eyes.left, &eyes.right}) {
      for (float& v : cells->even) v = grey(random);
      for (float& v : cells->odd) v = grey(random);
    }
    sum += Decoded(config, eyes).correlation;
  }
  EXPECT_NEAR(sum / trials, 0, 0.02);
}

}  // namespace
}  // namespace horopter::vision
