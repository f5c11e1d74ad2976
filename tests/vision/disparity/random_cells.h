// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

#include "vision/disparity/cell_image.h"
#include "vision/disparity/closed_form_kernels.h"

namespace horopter::vision::testing {

inline std::int8_t ToCell(double value) {
  return static_cast<std::int8_t>(std::lround(std::clamp(value, -kCellOne, kCellOne)));
}

/// Cells of random phases, each with all the power that the filters give: kCellPower.
inline CellImage RandomCells(cv::Size size, int orientations, std::uint64_t seed) {
  cv::RNG random(seed);
  CellImage image;
  image.Resize(size.width, size.height);
  std::fill_n(image.data(), size.area() * kLanes, std::int8_t{0});
  std::vector<double> parts(2 * orientations);
  for (int pixel = 0; pixel < size.area(); ++pixel) {
    double power = 0;
    for (double& part : parts) power += std::pow(part = random.gaussian(1), 2);
    const double gain = kCellOne * std::sqrt(kCellPower / power);
    std::int8_t* cell = image.data() + pixel * kLanes;
    for (int o = 0; o < orientations; ++o) {
      cell[o] = ToCell(gain * parts[2 * o]);
      cell[kMaxCellOrientations + o] = ToCell(gain * parts[2 * o + 1]);
    }
  }
  return image;
}

/// Cells whose parts are all +-127: more than filters give at a time, and as much as each may have.
inline CellImage ExtremeCells(cv::Size size, int orientations, std::uint64_t seed) {
  cv::RNG random(seed);
  CellImage image;
  image.Resize(size.width, size.height);
  std::fill_n(image.data(), size.area() * kLanes, std::int8_t{0});
  for (int i = 0; i < size.area() * kLanes; ++i) {
    if (i % kMaxCellOrientations < orientations) {
      image.data()[i] = random.uniform(0, 2) == 0 ? std::int8_t{-127} : std::int8_t{127};
    }
  }
  return image;
}

/// The response of an orientation at a pixel.
inline std::complex<double> Response(const CellView& cells, int x, int y, int orientation) {
  const std::int8_t* cell = cells.at(std::int64_t{y} * cells.width + x);
  return {static_cast<double>(cell[orientation]),
          static_cast<double>(cell[kMaxCellOrientations + orientation])};
}

/// What a move of (x, y) px turns the phase of an orientation by, as a factor.
inline std::complex<double> Turn(const CellBank& bank, int orientation, double x, double y) {
  return std::polar(1.0, (bank.nx(orientation) * x + bank.ny(orientation) * y) / bank.px_per_rad());
}

}  // namespace horopter::vision::testing
