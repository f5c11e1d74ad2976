// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "vision/disparity/closed_form_config.h"
#include "vision/disparity/closed_form_kernels.h"

namespace horopter::vision {

/// Values of a map, row by row, with some behind its end that vector loads may touch.
template <typename Value>
class PaddedMap {
 public:
  /// Keeps its memory when it shrinks or stays. Values are unspecified but for `fill`.
  void Resize(int width, int height, int per_pixel = 1) {
    const std::size_t needed = (static_cast<std::size_t>(width) * height + kPadding) * per_pixel;
    if (values_.size() < needed) values_.resize(needed);
  }
  Value* data() { return values_.data(); }
  const Value* data() const { return values_.data(); }

 private:
  static constexpr std::size_t kPadding = 16;
  std::vector<Value> values_;
};

/// Normalised responses of the simple cells of every pixel of an image, a byte for each part.
class CellImage {
 public:
  void Resize(int width, int height);
  CellView view() const { return {cells_.data(), width_, height_}; }
  std::int8_t* data() { return cells_.data(); }

 private:
  std::vector<std::int8_t> cells_;
  int width_ = 0;
  int height_ = 0;
};

/// The Gabor bank of the closed form and what its phases are turned by.
///
/// Response of orientation theta = i pi / n: complex Gabor of unit-sum Gaussian, its real part free
/// of DC, as GaborBank has it; then F / sqrt(|F|^2 + c^2 / 8) for each orientation, then the cell
/// as a whole to a power of kCellPower. The correlation of two cells is the product of their bytes.
class CellBank {
 public:
  /// @pre config.Validate() is empty
  explicit CellBank(const ClosedFormConfig& config);

  /// @param grey 0 to 255, width x height, with 8 values more behind the last
  void Apply(const ClosedFormKernels& kernels, const float* grey, int width, int height,
             CellImage& out) const;

  const PhaseTables& tables() const { return tables_; }
  int orientations() const { return orientations_; }
  /// Disparity along an orientation for a radian of its phase [px].
  double px_per_rad() const { return px_per_rad_; }
  double nx(int orientation) const;
  double ny(int orientation) const;

 private:
  void FillTaps(const ClosedFormConfig& config);
  void FillTables();

  int orientations_;
  int radius_;
  double peak_frequency_;
  double px_per_rad_;
  float saturation2_;
  std::vector<float> even_, odd_, across_even_, across_odd_, balance_;
  PhaseTables tables_;
};

}  // namespace horopter::vision
