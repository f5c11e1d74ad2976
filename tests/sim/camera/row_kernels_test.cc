// SPDX-License-Identifier: Apache-2.0
#include "sim/camera/row_kernels.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

#include "sim/camera/bilinear_row.h"

namespace horopter::sim {
namespace {

constexpr std::uint8_t kGuard = 0xa5;
constexpr std::size_t kGuards = 64;
/// Whole blocks of eight, and every number of pixels left over.
const std::vector<int> kWidths{1, 2, 3, 4, 5, 6, 7, 8, 9, 15, 16, 31, 64, 73, 640};

cv::Mat3b Speckles(int width, int height) {
  cv::Mat3b image(height, width);
  cv::RNG random(7);
  random.fill(image, cv::RNG::UNIFORM, 0, 256);
  return image;
}

/// A row's places, some of which lie beyond every side of a 90 x 60 image.
struct Row {
  Row(int row_width, bool sees_parallax)
      : width(row_width),
        parallax(sees_parallax),
        x(BilinearRow::RoundedUp(width)),
        y(x.size()),
        w(x.size()) {
    cv::RNG random(static_cast<std::uint64_t>(width));
    for (std::size_t i = 0; i < x.size(); ++i) {
      x[i] = random.uniform(-0.6F, 0.6F);
      y[i] = random.uniform(-0.6F, 0.6F);
      w[i] = random.uniform(0.0F, 3.0F);
    }
    H << 90, 1, 44.5, -2, 90, 29.5, 0.05F, 0.02F, 1;
  }

  /// Means of samples of the images, as an instruction set sees them.
  std::vector<std::uint8_t> Seen(const RowKernels& kernels,
                                 const std::vector<cv::Mat3b>& images) const;

  int width;
  bool parallax;
  std::vector<float> x, y, w;
  Eigen::Matrix3f H;
  Eigen::Vector3f e{2, -1, 0.01F};
};

/// A row of bytes that nobody may write beyond.
struct Guarded {
  explicit Guarded(int pixels) : bytes(3 * static_cast<std::size_t>(pixels) + kGuards, kGuard) {}
  std::uint8_t* data() { return bytes.data(); }
  bool Holds() const {
    return std::all_of(bytes.end() - kGuards, bytes.end(),
                       [](std::uint8_t byte) { return byte == kGuard; });
  }
  std::vector<std::uint8_t> bytes;
};

std::vector<std::uint8_t> Row::Seen(const RowKernels& kernels,
                                    const std::vector<cv::Mat3b>& images) const {
  BilinearRow sampler(kernels);
  for (const cv::Mat3b& image : images) sampler.Add(image, H, e);
  Guarded seen(width);
  sampler.Store({x.data(), y.data(), parallax ? w.data() : nullptr, width}, seen.data());
  EXPECT_TRUE(seen.Holds()) << kernels.name << " " << width;
  return seen.bytes;
}

/// The bilinear value by its definition, in double; places are rounded by up to 1/256 px.
double Expected(const cv::Mat3b& image, const Row& row, int i, int channel) {
  Eigen::Vector3d at = (row.H * Eigen::Vector3f(row.x[i], row.y[i], 1)).cast<double>();
  if (row.parallax) at += row.w[i] * row.e.cast<double>();
  const double u = std::clamp(at.x() / at.z(), 0.0, image.cols - 2 - 1.0 / 128);
  const double v = std::clamp(at.y() / at.z(), 0.0, image.rows - 1 - 1.0 / 128);
  const int x = static_cast<int>(u), y = static_cast<int>(v);
  const double right = u - x, down = v - y;
  return (1 - down) * ((1 - right) * image(y, x)[channel] + right * image(y, x + 1)[channel]) +
         down * ((1 - right) * image(y + 1, x)[channel] + right * image(y + 1, x + 1)[channel]);
}

TEST(RowKernels, SamplesAreBilinearValuesAndTheirMeans) {
  const cv::Mat3b image = Speckles(90, 60), other = cv::Scalar::all(255) - image;
  for (const RowKernels* kernels : UsableRowKernels()) {
    for (const bool parallax : {false, true}) {
      const Row row(640, parallax);
      const auto one = row.Seen(*kernels, {image}),
                 mean = row.Seen(*kernels, {image, image, other});
      for (int i = 0; i < 640; ++i) {
        for (int channel = 0; channel < 3; ++channel) {
          // A place is off by 1/256 px along each axis, and neighbours differ by up to 255.
          const double expected = Expected(image, row, i, channel);
          EXPECT_NEAR(one[3 * i + channel], expected, 2.6) << kernels->name << " " << i;
          EXPECT_NEAR(mean[3 * i + channel], (expected + 255) / 3, 1.4) << kernels->name;
        }
      }
    }
  }
}

TEST(RowKernels, EveryInstructionSetSamplesTheSameBitsAndStaysInItsRow) {
  const std::vector<cv::Mat3b> one{Speckles(90, 60)};
  const std::vector<cv::Mat3b> several{one[0], Speckles(70, 80), one[0]};
  const RowKernels& reference = *UsableRowKernels().back();
  for (const RowKernels* kernels : UsableRowKernels()) {
    for (const int width : kWidths) {
      for (const bool parallax : {false, true}) {
        const Row row(width, parallax);
        EXPECT_EQ(row.Seen(*kernels, one), row.Seen(reference, one)) << kernels->name;
        EXPECT_EQ(row.Seen(*kernels, several), row.Seen(reference, several)) << kernels->name;
      }
    }
  }
}

TEST(RowKernels, EveryInstructionSetExposesToTheSameBits) {
  const RowKernels& reference = *UsableRowKernels().back();
  const cv::Mat3b grey = Speckles(640, 1);
  std::vector<float> loss(3 * 640);
  for (std::size_t i = 0; i < loss.size(); ++i) loss[i] = 1e-4F * static_cast<float>(i % 4000);
  for (const float read_noise : {0.0F, 2.5F}) {
    for (const float shot_gain : {0.0F, 0.05F}) {
      for (const float gain : {1.0F, 1.7F}) {
        const SensorRow sensor{.loss = loss.data(),
                               .gain = gain,
                               .light = 0.9F,
                               .shot_gain = shot_gain,
                               .read_noise = read_noise,
                               .digits_per_level = 1,
                               .shot_key = 11,
                               .read_key = 12};
        for (const RowKernels* kernels : UsableRowKernels()) {
          for (const int width : kWidths) {
            Guarded row(width), expected(width);
            std::copy_n(grey.ptr(), 3 * width, row.data());
            std::copy_n(grey.ptr(), 3 * width, expected.data());
            kernels->expose(sensor, 3 * width, row.data());
            reference.expose(sensor, 3 * width, expected.data());
            EXPECT_EQ(row.bytes, expected.bytes) << kernels->name << " " << width;
            EXPECT_TRUE(row.Holds()) << kernels->name << " " << width;
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace horopter::sim
