// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/pyramid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>

namespace horopter::vision {
namespace {

/// Where a coarse pixel looks along one axis: three pixels from `first` on. Its triangle spans
/// 2 sqrt(2) px, so that it never holds a fourth.
struct Taps {
  int first;
  std::array<float, 3> weights;
};

std::vector<Taps> HalfOctaveTaps(int coarse_side) {
  std::vector<Taps> taps(coarse_side);
  for (int i = 0; i < coarse_side; ++i) {
    const double centre = std::numbers::sqrt2 * i;
    taps[i].first = static_cast<int>(std::ceil(centre - std::numbers::sqrt2));
    std::array<double, 3> weights;
    double sum = 0;
    for (int k = 0; k < 3; ++k) {
      const double distance = std::abs(taps[i].first + k - centre);
      weights[k] = std::max(0.0, 1 - distance / std::numbers::sqrt2);
      sum += weights[k];
    }
    for (int k = 0; k < 3; ++k) taps[i].weights[k] = static_cast<float>(weights[k] / sum);
  }
  return taps;
}

cv::Mat1f HalfOctaveDown(const cv::Mat1f& image, cv::Size size) {
  const std::vector<Taps> along_x = HalfOctaveTaps(size.width);
  const std::vector<Taps> along_y = HalfOctaveTaps(size.height);
  cv::Mat1f narrow(image.rows, size.width);
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const Taps& taps = along_x[x];
      float sum = 0;
      for (int k = 0; k < 3; ++k) {
        sum += taps.weights[k] * image(y, std::clamp(taps.first + k, 0, image.cols - 1));
      }
      narrow(y, x) = sum;
    }
  }
  cv::Mat1f out(size);
  for (int y = 0; y < size.height; ++y) {
    const Taps& taps = along_y[y];
    std::array<const float*, 3> rows;
    for (int k = 0; k < 3; ++k) rows[k] = narrow[std::clamp(taps.first + k, 0, image.rows - 1)];
    for (int x = 0; x < size.width; ++x) {
      out(y, x) = taps.weights[0] * rows[0][x] + taps.weights[1] * rows[1][x] +
                  taps.weights[2] * rows[2][x];
    }
  }
  return out;
}

cv::Mat1f Down(const cv::Mat1f& image, cv::Size size, PyramidStep step) {
  if (step == PyramidStep::kHalfOctave) return HalfOctaveDown(image, size);
  cv::Mat1f next;
  cv::pyrDown(image, next, size, cv::BORDER_REPLICATE);
  return next;
}

int CoarseSide(int fine_side, PyramidStep step) {
  return static_cast<int>((fine_side - 1) / LevelFactor(step)) + 1;
}

cv::Mat Upsample(const cv::Mat& coarse, cv::Size fine, PyramidStep step, int interpolation) {
  // cv::resize would align the corners of the corner pixels, not their centres.
  const double scale = 1 / LevelFactor(step);
  const cv::Matx23d coarse_from_fine(scale, 0, 0, 0, scale, 0);
  cv::Mat out;
  cv::warpAffine(coarse, out, coarse_from_fine, fine, interpolation | cv::WARP_INVERSE_MAP,
                 cv::BORDER_REPLICATE);
  return out;
}

}  // namespace

double LevelFactor(PyramidStep step) {
  return step == PyramidStep::kOctave ? 2 : std::numbers::sqrt2;
}

std::vector<cv::Mat1f> BuildPyramid(const cv::Mat1f& image, int scales, int min_side_px,
                                    PyramidStep step) {
  std::vector<cv::Mat1f> levels = {image};
  while (static_cast<int>(levels.size()) < scales) {
    const cv::Size fine = levels.back().size();
    const cv::Size coarse(CoarseSide(fine.width, step), CoarseSide(fine.height, step));
    // From one or two pixels on a level is no smaller than the one before.
    if (std::min(coarse.width, coarse.height) < min_side_px || coarse == fine) break;
    levels.push_back(Down(levels.back(), coarse, step));
  }
  return levels;
}

cv::Mat1f UpsampleDisparity(const cv::Mat1f& coarse, cv::Size fine, PyramidStep step) {
  return LevelFactor(step) * Upsample(coarse, fine, step, cv::INTER_LINEAR);
}

cv::Mat UpsampleNearest(const cv::Mat& coarse, cv::Size fine, PyramidStep step) {
  return Upsample(coarse, fine, step, cv::INTER_NEAREST);
}

}  // namespace horopter::vision
