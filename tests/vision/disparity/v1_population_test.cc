// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/v1_population.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <random>
#include <vector>

namespace horopter::vision {
namespace {

/// One eye's responses at a pixel.
struct Eye {
  std::vector<float> even, odd;
  SimpleCells cells() const { return {even.data(), odd.data()}; }
};

/// Responses of both eyes to a wave packet that holds every orientation, displaced by (dx, dy).
struct Eyes {
  Eye left;
  Eye right;
};

Eyes Displaced(const V1Config& config, double dx, double dy, double magnitude = 20) {
  Eyes eyes;
  for (int i = 0; i < config.orientations; ++i) {
    const double theta = OrientationRad(i, config.orientations);
    const double along = dx * std::cos(theta) + dy * std::sin(theta);
    const std::complex<double> left = std::polar(magnitude, 0.7 * i);
    const std::complex<double> right =
        left * std::polar(1.0, -2 * M_PI * config.peak_frequency * along);
    eyes.left.even.push_back(static_cast<float>(left.real()));
    eyes.left.odd.push_back(static_cast<float>(left.imag()));
    eyes.right.even.push_back(static_cast<float>(right.real()));
    eyes.right.odd.push_back(static_cast<float>(right.imag()));
  }
  return eyes;
}

PopulationDisparity Decoded(const V1Config& config, const Eyes& eyes) {
  const Population population(config);
  return population.Intersect(
      population.Decode(eyes.left.cells(), eyes.right.cells(), population.TexturelessEnergy(0)));
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

TEST(Population, DecodesWithAnyNumberOfOrientationsAndPhaseShifts) {
  for (const int orientations : {2, 3, 9, kMaxOrientations}) {
    for (const int shifts : {5, 8, 11, kMaxPhaseShifts}) {
      V1Config config;
      config.orientations = orientations;
      config.min_orientations = 2;
      config.phase_shifts = shifts;
      const PopulationDisparity decoded = Decoded(config, Displaced(config, 0.4, -0.3));
      ASSERT_TRUE(decoded.solved) << orientations << " x " << shifts;
      EXPECT_NEAR(decoded.dx, 0.4, 0.1) << orientations << " x " << shifts;
      EXPECT_NEAR(decoded.dy, -0.3, 0.1) << orientations << " x " << shifts;
    }
  }
}

TEST(Population, FixedAndFreeCountsGiveTheSame) {
  // An orientation that sees nothing changes only how many count.
  const V1Config eight;
  V1Config sixteen;
  sixteen.orientations = 16;
  const Eyes few = Displaced(eight, 0.7, 0.2);
  Eyes many = Displaced(sixteen, 0.7, 0.2);
  for (int i = 0; i < 16; ++i) {
    const bool shared = i % 2 == 0;
    many.left.even[i] = shared ? few.left.even[i / 2] : 0;
    many.left.odd[i] = shared ? few.left.odd[i / 2] : 0;
    many.right.even[i] = shared ? few.right.even[i / 2] : 0;
    many.right.odd[i] = shared ? few.right.odd[i / 2] : 0;
  }
  const PopulationDisparity a = Decoded(eight, few), b = Decoded(sixteen, many);
  EXPECT_NEAR(a.dx, b.dx, 1e-5);
  EXPECT_NEAR(a.dy, b.dy, 1e-5);
  EXPECT_NEAR(a.correlation, b.correlation, 1e-5);
}

TEST(Population, AnExponentIsAppliedToTheEnergies) {
  V1Config config;
  config.energy_exponent = 0.18;
  const Eyes eyes = Displaced(config, 0.3, 0.4);
  BinocularEnergy::Energies plain, raised;
  const BinocularEnergy energy(config);
  energy.Magnitudes<0, 0>(eyes.left.cells(), eyes.right.cells(), plain);
  raised = plain;
  EXPECT_TRUE(energy.Compress(raised));
  EXPECT_NEAR(raised[3][2], std::pow(plain[3][2], 0.18), 1e-5);
  const PopulationDisparity decoded = Decoded(config, eyes);
  EXPECT_NEAR(decoded.dx, 0.3, 0.15);
  EXPECT_NEAR(decoded.dy, 0.4, 0.15);
  EXPECT_FALSE(BinocularEnergy(V1Config()).Compress(raised));
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
  for (int i = 0; i < config.orientations; ++i) {
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
  EXPECT_EQ(population.Decode(weak.left.cells(), weak.right.cells(), noise).count, 0);
  EXPECT_EQ(population.Decode(strong.left.cells(), strong.right.cells(), noise).count,
            config.orientations);
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
  for (int i = 0; i < config.orientations; ++i) {
    if (i == 0 || i == config.orientations / 2) continue;  // these two alone see something
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
  for (int i = 0; i < config.orientations; ++i) {
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
    for (Eye* eye : {&eyes.left, &eyes.right}) {
      for (int i = 0; i < config.orientations; ++i) {
        eye->even.push_back(grey(random));
        eye->odd.push_back(grey(random));
      }
    }
    sum += Decoded(config, eyes).correlation;
  }
  EXPECT_NEAR(sum / trials, 0, 0.02);
}

}  // namespace
}  // namespace horopter::vision
