// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <opencv2/core.hpp>
#include <vector>

#include "vision/disparity/disparity_field.h"

namespace horopter::vision::testing {

/// A pair whose left pixel (x, y) shows what the right image shows at map(x, y).
struct SyntheticPair {
  cv::Mat1b left;
  cv::Mat1b right;
};

/// Texture with periods of 3 px looks like a poor camera's noise (NoiseLevel: 5 grey levels), one
/// of 4 px much less so (2).
inline constexpr double kNoisyTexturePx = 3, kCleanTexturePx = 4;

/// Seeded noise as a function of the plane, exact at any position: sinusoids in random directions,
/// equally many per octave from periods of 64 px to the finest, grey 0 to 255.
class NoiseTexture {
 public:
  explicit NoiseTexture(std::uint64_t seed, double finest_px) {
    cv::RNG rng(seed);
    for (int i = 0; i < kWaves; ++i) {
      const double frequency = std::exp(rng.uniform(std::log(1 / 64.0), std::log(1 / finest_px)));
      const double direction = rng.uniform(0.0, CV_PI);
      waves_.push_back({static_cast<float>(2 * CV_PI * frequency * std::cos(direction)),
                        static_cast<float>(2 * CV_PI * frequency * std::sin(direction)),
                        static_cast<float>(rng.uniform(0.0, 2 * CV_PI))});
    }
  }

  unsigned char operator()(double x, double y) const {
    float sum = 0;
    for (const Wave& wave : waves_) {
      sum += std::sin(wave.x * static_cast<float>(x) + wave.y * static_cast<float>(y) + wave.phase);
    }
    return cv::saturate_cast<unsigned char>(127.5F + 40 * sum / std::sqrt(kWaves / 2.0F));
  }

 private:
  struct Wave {
    float x, y, phase;
  };
  static constexpr int kWaves = 96;
  std::vector<Wave> waves_;
};

/// The texture seen by the left eye, and by a right eye such that left (x, y) matches right
/// H (x, y, 1). The texture goes on beyond both images.
inline SyntheticPair WarpedPair(cv::Size size, const cv::Matx33d& H, std::uint64_t seed = 1,
                                double finest_px = kNoisyTexturePx) {
  const NoiseTexture texture(seed, finest_px);
  const cv::Matx33d left_from_right = H.inv();
  SyntheticPair pair{cv::Mat1b(size), cv::Mat1b(size)};
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const cv::Vec3d p = left_from_right * cv::Vec3d(x, y, 1);
      pair.left(y, x) = texture(x, y);
      pair.right(y, x) = texture(p[0] / p[2], p[1] / p[2]);
    }
  }
  return pair;
}

inline SyntheticPair ShiftedPair(cv::Size size, double dx, double dy, std::uint64_t seed = 1,
                                 double finest_px = kNoisyTexturePx) {
  return WarpedPair(size, cv::Matx33d(1, 0, dx, 0, 1, dy, 0, 0, 1), seed, finest_px);
}

/// Density and errors against left (x, y) matching right H (x, y, 1), over the pixels whose match
/// lies inside the right image.
struct WarpScore {
  double density = 0;
  double median_error_px = std::numeric_limits<double>::quiet_NaN();
};

inline WarpScore ScoreWarp(const DisparityField& field, const cv::Matx33d& H) {
  std::vector<double> errors;
  int possible = 0;
  for (int y = 0; y < field.valid.rows; ++y) {
    for (int x = 0; x < field.valid.cols; ++x) {
      const cv::Vec3d match = H * cv::Vec3d(x, y, 1);
      const double true_x = match[0] / match[2];
      const double true_y = match[1] / match[2];
      if (true_x < 0 || true_y < 0 || true_x > field.valid.cols - 1 ||
          true_y > field.valid.rows - 1) {
        continue;
      }
      ++possible;
      if (field.valid(y, x) == 0) continue;
      errors.push_back(std::hypot(x + field.dx(y, x) - true_x, y + field.dy(y, x) - true_y));
    }
  }
  WarpScore score;
  if (possible > 0) score.density = static_cast<double>(errors.size()) / possible;
  if (!errors.empty()) {
    const auto middle = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2);
    std::nth_element(errors.begin(), middle, errors.end());
    score.median_error_px = *middle;
  }
  return score;
}

}  // namespace horopter::vision::testing
