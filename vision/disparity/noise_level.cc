// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/noise_level.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace horopter::vision {

namespace {

/// The share of all second differences that is smaller, in deviations of the noise that would make
/// their median.
double Quantile(const cv::Mat1f& grey, double share) {
  // The operator's weights have a root sum of squares of 6; the median magnitude of a Gaussian is
  // 0.6745 of its deviation.
  constexpr double kMedianOfUnit = 6 * 0.6745;
  constexpr int kEvery = 3;  // neighbouring differences share pixels, and say little more
  std::vector<float> magnitudes;
  for (int y = 1; y + 1 < grey.rows; y += kEvery) {
    const float *above = grey[y - 1], *row = grey[y], *below = grey[y + 1];
    for (int x = 1; x + 1 < grey.cols; x += kEvery) {
      const auto along_x = [x](const float* r) { return r[x - 1] - 2 * r[x] + r[x + 1]; };
      magnitudes.push_back(std::abs(along_x(above) - 2 * along_x(row) + along_x(below)));
    }
  }
  if (magnitudes.empty()) return 0;
  const auto at = magnitudes.begin() +
                  static_cast<std::ptrdiff_t>(share * static_cast<double>(magnitudes.size() - 1));
  std::nth_element(magnitudes.begin(), at, magnitudes.end());
  return *at / kMedianOfUnit;
}

}  // namespace

double NoiseLevel(const cv::Mat1f& grey) { return Quantile(grey, 0.5); }

double TextureLevel(const cv::Mat1f& grey) { return Quantile(grey, 0.8); }

double NoiseAtOctave(double noise_grey, int octave) {
  // Of white noise; what is left is smoother, and dies more slowly after.
  constexpr double kFirst = 70.0 / 256, kNext = 0.48;
  return octave == 0 ? noise_grey : noise_grey * kFirst * std::pow(kNext, octave - 1);
}

}  // namespace horopter::vision
