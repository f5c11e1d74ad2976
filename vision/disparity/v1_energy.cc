// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/v1_energy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "vision/disparity/fill_in.h"
#include "vision/disparity/image_pair.h"
#include "vision/disparity/left_right_check.h"
#include "vision/disparity/local_normalisation.h"
#include "vision/disparity/pyramid.h"
#include "vision/disparity/small_segments.h"

namespace horopter::vision {
namespace {

V1Config Checked(const V1Config& config) {
  hardware::ThrowIfAny(config.Validate());
  return config;
}

DisparityField ZeroField(cv::Size size) {
  return {cv::Mat1f::zeros(size), cv::Mat1f::zeros(size), cv::Mat1f::zeros(size),
          cv::Mat1b::zeros(size)};
}

/// The field of a level as the start of the next finer one. Confidence halves with every octave,
/// and `valid` counts down with every level that does not confirm it.
DisparityField Propagate(const DisparityField& coarse, cv::Size fine, PyramidStep step) {
  DisparityField field;
  field.dx = UpsampleDisparity(coarse.dx, fine, step);
  field.dy = UpsampleDisparity(coarse.dy, fine, step);
  field.confidence = UpsampleNearest(coarse.confidence, fine, step) / LevelFactor(step);
  cv::subtract(UpsampleNearest(coarse.valid, fine, step), 1, field.valid);
  return field;
}

bool Inside(float x, float y, cv::Size size) {
  return x >= 0 && y >= 0 && x <= static_cast<float>(size.width - 1) &&
         y <= static_cast<float>(size.height - 1);
}

/// What every pixel's neurons see, as the decoder wants it pooled: a Mat with a channel for each of
/// its numbers. The right responses are warped by the field's disparity.
template <typename Decoder>
cv::Mat SenseAll(const Decoder& decoder, const SimpleCellMap& from, const SimpleCellMap& to,
                 float textureless, const DisparityField& field) {
  const int floats = decoder.floats();
  cv::Mat sums(from.size(), CV_32FC(floats));
  cv::parallel_for_(cv::Range(0, sums.rows), [&](const cv::Range& rows) {
    std::array<float, 2 * kMaxOrientations> match;
    const SimpleCells right{match.data(), match.data() + to.orientations()};
    for (int y = rows.start; y < rows.end; ++y) {
      const SimpleCellMap::Row cells = from.row(y);
      float* out = sums.ptr<float>(y);
      for (int x = 0; x < sums.cols; ++x, out += floats) {
        const float match_x = static_cast<float>(x) + field.dx(y, x);
        const float match_y = static_cast<float>(y) + field.dy(y, x);
        if (Inside(match_x, match_y, to.size())) {
          to.At(match_x, match_y, match.data());
          decoder.Sense(cells[x], right, textureless, out);
        } else {
          std::fill_n(out, floats, 0.0F);
        }
      }
    }
  });
  return sums;
}

}  // namespace

V1EnergyEstimator::V1EnergyEstimator(const V1Config& config)
    : config_(Checked(config)), bank_(config), population_(config), readout_(config) {}

DisparityField V1EnergyEstimator::Estimate(const cv::Mat& left, const cv::Mat& right,
                                           hardware::StageTimes* times) {
  CheckPair(left, right);
  View left_view, right_view;
  hardware::MeasureIf(times, "simple cells", [&] {
    left_view = See(left);
    right_view = See(right);
  });
  DisparityField field, back;
  hardware::MeasureIf(times, "coarse to fine", [&] {
    field = CoarseToFine(left_view, right_view);
    if (config_.left_right_px > 0) back = CoarseToFine(right_view, left_view);
  });
  if (config_.left_right_px > 0) CheckLeftRight(back, config_.left_right_px, field);
  if (config_.min_segment_px > 1) {
    InvalidateSmallSegments(config_.min_segment_px, config_.segment_step_px, field);
  }
  if (config_.fill_in) FillIn(ToGrey(left), config_.fill, field);
  BlankInvalid(field);
  return field;
}

V1EnergyEstimator::View V1EnergyEstimator::See(const cv::Mat& image) const {
  cv::Mat1f grey;
  ToGrey(image).convertTo(grey, CV_32F);
  View view;
  double floor = config_.noise_grey;
  for (const cv::Mat1f& level :
       BuildPyramid(grey, config_.scales, config_.min_side_px, config_.pyramid)) {
    if (config_.normalisation_px > 0) {
      view.cells.push_back(bank_.Apply(NormaliseLocally(level, config_.normalisation_px, floor)));
      floor /= LevelFactor(config_.pyramid);  // noise halves with every octave
    } else {
      view.cells.push_back(bank_.Apply(level));
    }
    if (config_.fill_in) level.convertTo(view.grey.emplace_back(), CV_8U);
  }
  return view;
}

DisparityField V1EnergyEstimator::CoarseToFine(const View& from, const View& to) const {
  DisparityField field = ZeroField(from.cells.back().size());
  for (std::size_t level = from.cells.size(); level-- > 0;) {
    if (level + 1 < from.cells.size()) {
      field = Propagate(field, from.cells[level].size(), config_.pyramid);
    }
    for (int i = 0; i < config_.iterations; ++i) Refine(from, to, level, field);
    if (config_.median_px > 0) {
      cv::medianBlur(field.dx, field.dx, config_.median_px);
      cv::medianBlur(field.dy, field.dy, config_.median_px);
    }
  }
  cv::threshold(field.valid, field.valid, 0, 255, cv::THRESH_BINARY);
  InvalidateOutside(field, config_.border_px);
  return field;
}

void V1EnergyEstimator::Refine(const View& from, const View& to, std::size_t level,
                               DisparityField& field) const {
  if (config_.decoding == V1Decoding::kLinear) {
    RefineBy(readout_, from, to, level, field);
  } else {
    RefineBy(population_, from, to, level, field);
  }
}

void V1EnergyEstimator::Pool(cv::Mat& sums) const {
  const double sigma = config_.pooling_sigma_px;
  if (!(sigma > 0)) return;
  if (config_.decoding == V1Decoding::kLinear) {
    // Cut at three deviations, as published: 11x11. Nothing is seen beyond the border.
    const int side = 2 * static_cast<int>(3 * sigma) + 1;
    cv::GaussianBlur(sums, sums, cv::Size(side, side), sigma, 0, cv::BORDER_CONSTANT);
  } else {
    cv::GaussianBlur(sums, sums, cv::Size(), sigma, 0, cv::BORDER_REPLICATE);
  }
}

template <typename Decoder>
void V1EnergyEstimator::RefineBy(const Decoder& decoder, const View& from, const View& to,
                                 std::size_t level, DisparityField& field) const {
  const int levels_per_octave = LevelsPerOctave(config_.pyramid);
  const float textureless =
      decoder.TexturelessEnergy(static_cast<double>(level) / levels_per_octave);
  cv::Mat sums = SenseAll(decoder, from.cells[level], to.cells[level], textureless, field);
  Pool(sums);

  const auto confirmed =
      static_cast<unsigned char>(config_.max_kept_octaves * levels_per_octave + 1);
  const auto min_correlation = static_cast<float>(config_.min_correlation);
  DisparityField steps = config_.fill_in ? ZeroField(sums.size()) : DisparityField();
  cv::parallel_for_(cv::Range(0, sums.rows), [&](const cv::Range& rows) {
    for (int y = rows.start; y < rows.end; ++y) {
      const float* row = sums.ptr<float>(y);
      for (int x = 0; x < sums.cols; ++x) {
        const PopulationDisparity step =
            decoder.Read(row + static_cast<std::ptrdiff_t>(x) * decoder.floats());
        if (!step.solved) continue;
        field.dx(y, x) += step.dx;
        field.dy(y, x) += step.dy;
        field.confidence(y, x) = std::max(step.correlation, 0.0F);
        field.valid(y, x) = step.correlation >= min_correlation ? confirmed : 0;
        if (steps.valid.empty()) continue;
        steps.dx(y, x) = step.dx;
        steps.dy(y, x) = step.dy;
        steps.confidence(y, x) = field.confidence(y, x);
        steps.valid(y, x) = 255;
      }
    }
  });
  if (!config_.fill_in) return;
  // The readout is linear in the cells of MT: to fill in their activity, as published, is to fill
  // in the step that it decodes to.
  FillIn(from.grey[level], config_.fill, steps);
  cv::add(field.dx, steps.dx, field.dx, steps.filled);
  cv::add(field.dy, steps.dy, field.dy, steps.filled);
}

}  // namespace horopter::vision
