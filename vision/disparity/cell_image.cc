// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/cell_image.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace horopter::vision {
namespace {

constexpr double kPi = std::numbers::pi;

/// Part of a cell's power that stands against noise: a textureless cell stays below it.
constexpr double kPowerFloor = 0.02;

/// Writes the two vectors that turn every orientation's phase by what a move of (x, y) px does to
/// it.
template <typename Number>
void WriteTurn(const CellBank& bank, double x, double y, double one, Number* entry) {
  for (int o = 0; o < bank.orientations(); ++o) {
    const double phase = (bank.nx(o) * x + bank.ny(o) * y) / bank.px_per_rad();
    const auto c = static_cast<Number>(std::lround(one * std::cos(phase)));
    const auto s = static_cast<Number>(std::lround(one * std::sin(phase)));
    entry[o] = entry[kMaxCellOrientations + o] = c;
    entry[kLanes + o] = static_cast<Number>(-s);
    entry[kLanes + kMaxCellOrientations + o] = s;
  }
}

}  // namespace

void CellImage::Resize(int width, int height) {
  width_ = width;
  height_ = height;
  const std::size_t outside = static_cast<std::size_t>(width) * height * kLanes;
  if (cells_.size() < outside + kLanes) cells_.resize(outside + kLanes);
  std::fill_n(cells_.begin() + static_cast<std::ptrdiff_t>(outside), kLanes, std::int8_t{0});
}

CellBank::CellBank(const ClosedFormConfig& config)
    : orientations_(config.orientations),
      radius_(config.filter_px / 2),
      peak_frequency_(config.peak_frequency),
      px_per_rad_(1 / (2 * kPi * config.peak_frequency)),
      saturation2_(static_cast<float>(config.saturation_grey * config.saturation_grey / 8)),
      tables_{} {
  FillTaps(config);
  FillTables();
}

double CellBank::nx(int orientation) const { return std::cos(orientation * kPi / orientations_); }
double CellBank::ny(int orientation) const { return std::sin(orientation * kPi / orientations_); }

void CellBank::FillTaps(const ClosedFormConfig& config) {
  std::vector<double> gaussian;
  double sum = 0;
  for (int t = 0; t <= radius_; ++t) {
    gaussian.push_back(
        std::exp(-t * t / (2 * config.envelope_sigma_px * config.envelope_sigma_px)));
    sum += (t > 0 ? 2 : 1) * gaussian.back();
  }
  const auto append = [&](double frequency, std::vector<float>& even, std::vector<float>& odd) {
    double total = 0;
    for (int t = 0; t <= radius_; ++t) {
      const double phase = 2 * kPi * frequency * t, weight = gaussian[t] / sum;
      even.push_back(static_cast<float>(weight * std::cos(phase)));
      odd.push_back(static_cast<float>(-weight * std::sin(phase)));
      total += (t > 0 ? 2 : 1) * weight * std::cos(phase);
    }
    return total;
  };
  for (int i = 0; i <= orientations_ / 2; ++i) {
    const double along_y = append(peak_frequency_ * ny(i), even_, odd_);
    const double along_x = append(peak_frequency_ * nx(i), across_even_, across_odd_);
    balance_.push_back(static_cast<float>(along_x * along_y));
  }
}

void CellBank::FillTables() {
  constexpr int kHalf = kHypothesisSteps / 2;
  for (int y = 0; y < kHypothesisSteps; ++y) {
    for (int x = 0; x < kHypothesisSteps; ++x) {
      WriteTurn(*this, (x - kHalf) / double{kHypothesisSteps},
                (y - kHalf) / double{kHypothesisSteps}, kCellOne,
                &tables_.turn[static_cast<std::size_t>(y * kHypothesisSteps + x) * 2 * kLanes]);
    }
  }
  constexpr double kFine = 32767;
  for (int i = 0; i <= 64; ++i) {
    WriteTurn(*this, i / 64.0, 0, kFine, &tables_.turn_x[static_cast<std::size_t>(i) * 2 * kLanes]);
    WriteTurn(*this, 0, i / 64.0, kFine, &tables_.turn_y[static_cast<std::size_t>(i) * 2 * kLanes]);
  }
  WriteTurn(*this, -1, 0, kFine, &tables_.from_corner[0]);
  WriteTurn(*this, 0, -1, kFine, &tables_.from_corner[2 * kLanes]);
  WriteTurn(*this, -1, -1, kFine, &tables_.from_corner[4 * kLanes]);
}

void CellBank::Apply(const ClosedFormKernels& kernels, const float* grey, int width, int height,
                     CellImage& out) const {
  out.Resize(width, height);
  const FilterTask task{grey,
                        width,
                        height,
                        out.data(),
                        orientations_,
                        radius_,
                        even_.data(),
                        odd_.data(),
                        across_even_.data(),
                        across_odd_.data(),
                        balance_.data(),
                        saturation2_,
                        static_cast<float>(kPowerFloor * orientations_)};
  const std::size_t scratch_size =
      static_cast<std::size_t>(PaddedRow(width, radius_)) * (orientations_ + 2);
  constexpr int kRowsAtOnce = 8;
  tbb::parallel_for(tbb::blocked_range<int>(0, height, kRowsAtOnce), [&](const auto& rows) {
    thread_local std::vector<float> scratch;
    if (scratch.size() < scratch_size) scratch.resize(scratch_size);
    for (int y = rows.begin(); y < rows.end(); ++y) kernels.filter_row(task, y, scratch.data());
  });
}

}  // namespace horopter::vision
