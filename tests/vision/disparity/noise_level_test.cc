// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/noise_level.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace horopter::vision {
namespace {

/// A slope with a step, and noise.
cv::Mat1f Noisy(cv::Size size, double sigma) {
  cv::Mat1f image(size);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      image(y, x) = 60 + 0.3F * static_cast<float>(x) + (y > size.height / 2 ? 50.0F : 0.0F);
    }
  }
  cv::Mat1f noise(size);
  cv::RNG random(3);
  random.fill(noise, cv::RNG::NORMAL, 0, sigma);
  return image + noise;
}

TEST(NoiseLevel, IsThatOfTheNoiseOnSlopesAndSteps) {
  for (const double sigma : {0.5, 2.0, 10.0}) {
    EXPECT_NEAR(NoiseLevel(Noisy({320, 240}, sigma)), sigma, 0.05 * sigma);
  }
  EXPECT_NEAR(NoiseLevel(Noisy({320, 240}, 0)), 0, 1e-4);
}

TEST(TextureLevel, OfHalfTheSizeHearsTextureAndLittleNoise) {
  cv::Mat1f texture(480, 640);
  for (int y = 0; y < texture.rows; ++y) {
    for (int x = 0; x < texture.cols; ++x) {
      texture(y, x) = static_cast<float>(100 + 20 * std::sin(x / 1.5) * std::cos(y / 1.5));
    }
  }
  const auto at_half = [](const cv::Mat1f& image) {
    cv::Mat1f half;
    cv::pyrDown(image, half);
    return TextureLevel(half);
  };
  const double clean = at_half(texture);
  EXPECT_GT(clean, 1);
  EXPECT_NEAR(at_half(texture + Noisy(texture.size(), 4) - Noisy(texture.size(), 0)), clean,
              0.3 * clean);
  EXPECT_LT(at_half(Noisy(texture.size(), 4)), 0.5 * NoiseLevel(Noisy(texture.size(), 4)));
}

TEST(NoiseLevel, IsNoneWhereTheOperatorDoesNotFit) {
  EXPECT_EQ(NoiseLevel(cv::Mat1f(2, 50, 7.0F)), 0);
  EXPECT_EQ(NoiseLevel(cv::Mat1f(50, 1, 7.0F)), 0);
}

TEST(NoiseAtOctave, IsWhatThePyramidLeaves) {
  cv::Mat1f noise(960, 1280);
  cv::RNG random(5);
  random.fill(noise, cv::RNG::NORMAL, 0, 10);
  for (int octave = 0; octave <= 4; ++octave) {
    cv::Scalar mean, deviation;
    cv::meanStdDev(noise, mean, deviation);
    EXPECT_NEAR(NoiseAtOctave(10, octave), deviation[0], 0.15 * deviation[0]) << octave;
    cv::Mat1f next;
    cv::pyrDown(noise, next);
    noise = next;
  }
}

}  // namespace
}  // namespace horopter::vision
