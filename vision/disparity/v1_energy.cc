// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/v1_energy.h"

#include <algorithm>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "vision/disparity/image_pair.h"
#include "vision/disparity/left_right_check.h"
#include "vision/disparity/pyramid.h"
#include "vision/disparity/small_segments.h"

namespace horopter::vision {
namespace {

V1Config Checked(const V1Config& config) {
  hardware::ThrowIfAny(config.Validate());
  return config;
}

constexpr int kConstraintFloats = sizeof(Constraints) / sizeof(float);

/// The state that passes from scale to scale. `valid` is never 0 here once a scale saw the pixel.
DisparityField ZeroField(cv::Size size) {
  return {cv::Mat1f::zeros(size), cv::Mat1f::zeros(size), cv::Mat1f::zeros(size),
          cv::Mat1b::zeros(size)};
}

/// The field of an octave as the start of the next finer one. `valid` counts down with every
/// octave that does not confirm it.
DisparityField Propagate(const DisparityField& coarse, cv::Size fine) {
  DisparityField field;
  field.dx = UpsampleDisparity(coarse.dx, fine);
  field.dy = UpsampleDisparity(coarse.dy, fine);
  field.confidence = 0.5 * UpsampleNearest(coarse.confidence, fine);
  cv::subtract(UpsampleNearest(coarse.valid, fine), 1, field.valid);
  return field;
}

bool Inside(float x, float y, cv::Size size) {
  return x >= 0 && y >= 0 && x <= static_cast<float>(size.width - 1) &&
         y <= static_cast<float>(size.height - 1);
}

}  // namespace

V1EnergyEstimator::V1EnergyEstimator(const V1Config& config)
    : config_(Checked(config)), bank_(config), population_(config) {}

DisparityField V1EnergyEstimator::Estimate(const cv::Mat& left, const cv::Mat& right,
                                           hardware::StageTimes* times) {
  CheckPair(left, right);
  CellPyramid left_cells, right_cells;
  hardware::MeasureIf(times, "simple cells", [&] {
    left_cells = Filter(left);
    right_cells = Filter(right);
  });
  DisparityField field, back;
  hardware::MeasureIf(times, "coarse to fine", [&] {
    field = CoarseToFine(left_cells, right_cells);
    if (config_.left_right_px > 0) back = CoarseToFine(right_cells, left_cells);
  });
  if (config_.left_right_px > 0) CheckLeftRight(back, config_.left_right_px, field);
  if (config_.min_segment_px > 1) {
    InvalidateSmallSegments(config_.min_segment_px, config_.segment_step_px, field);
  }
  BlankInvalid(field);
  return field;
}

V1EnergyEstimator::CellPyramid V1EnergyEstimator::Filter(const cv::Mat& image) const {
  cv::Mat1f grey;
  ToGrey(image).convertTo(grey, CV_32F);
  CellPyramid cells;
  for (const cv::Mat1f& octave : BuildPyramid(grey, config_.scales, config_.min_side_px)) {
    cells.push_back(bank_.Apply(octave));
  }
  return cells;
}

DisparityField V1EnergyEstimator::CoarseToFine(const CellPyramid& from,
                                               const CellPyramid& to) const {
  DisparityField field = ZeroField(from.back().size());
  for (std::size_t scale = from.size(); scale-- > 0;) {
    if (scale + 1 < from.size()) field = Propagate(field, from[scale].size());
    for (int i = 0; i < config_.iterations; ++i)
      Refine(from[scale], to[scale], static_cast<int>(scale), field);
    if (config_.median_px > 0) {
      cv::medianBlur(field.dx, field.dx, config_.median_px);
      cv::medianBlur(field.dy, field.dy, config_.median_px);
    }
  }
  cv::threshold(field.valid, field.valid, 0, 255, cv::THRESH_BINARY);
  InvalidateOutside(field, config_.border_px);
  return field;
}

void V1EnergyEstimator::Refine(const SimpleCellMap& from, const SimpleCellMap& to, int octave,
                               DisparityField& field) const {
  cv::Mat constraints = DecodeAll(from, to, octave, field);
  if (config_.pooling_sigma_px > 0) {
    cv::GaussianBlur(constraints, constraints, cv::Size(), config_.pooling_sigma_px, 0,
                     cv::BORDER_REPLICATE);
  }
  const auto confirmed = static_cast<unsigned char>(config_.max_kept_octaves + 1);
  const auto min_correlation = static_cast<float>(config_.min_correlation);
  cv::parallel_for_(cv::Range(0, constraints.rows), [&](const cv::Range& rows) {
    for (int y = rows.start; y < rows.end; ++y) {
      const auto* row = reinterpret_cast<const Constraints*>(constraints.ptr<float>(y));
      for (int x = 0; x < constraints.cols; ++x) {
        const PopulationDisparity step = population_.Intersect(row[x]);
        if (!step.solved) continue;
        field.dx(y, x) += step.dx;
        field.dy(y, x) += step.dy;
        field.confidence(y, x) = std::max(step.correlation, 0.0F);
        field.valid(y, x) = step.correlation >= min_correlation ? confirmed : 0;
      }
    }
  });
}

cv::Mat V1EnergyEstimator::DecodeAll(const SimpleCellMap& from, const SimpleCellMap& to, int octave,
                                     const DisparityField& field) const {
  const float textureless = population_.TexturelessEnergy(octave);
  cv::Mat constraints(from.size(), CV_32FC(kConstraintFloats));
  cv::parallel_for_(cv::Range(0, constraints.rows), [&](const cv::Range& rows) {
    for (int y = rows.start; y < rows.end; ++y) {
      const SimpleCells* cells = from.row(y);
      auto* out = reinterpret_cast<Constraints*>(constraints.ptr<float>(y));
      for (int x = 0; x < constraints.cols; ++x) {
        const float match_x = static_cast<float>(x) + field.dx(y, x);
        const float match_y = static_cast<float>(y) + field.dy(y, x);
        out[x] = Inside(match_x, match_y, to.size())
                     ? population_.Decode(cells[x], to.At(match_x, match_y), textureless)
                     : Constraints();
      }
    }
  });
  return constraints;
}

}  // namespace horopter::vision
