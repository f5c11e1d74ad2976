// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/v1_closed_form.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>

#include "vision/disparity/fill_in.h"
#include "vision/disparity/image_pair.h"
#include "vision/disparity/left_right_check.h"
#include "vision/disparity/pyramid.h"
#include "vision/disparity/small_segments.h"

namespace horopter::vision {
namespace {

ClosedFormConfig Checked(const ClosedFormConfig& config) {
  hardware::ThrowIfAny(config.Validate());
  return config;
}

/// Two functions at once, where the second is asked for.
template <typename First, typename Second>
void Both(bool also_second, First first, Second second) {
  if (also_second) {
    tbb::parallel_invoke(first, second);
  } else {
    first();
  }
}

/// A field of an octave in the pixels of the image, for every one of them.
void Enlarge(int octave, cv::Size image, DisparityField& field) {
  for (; octave > 0; --octave) {
    // Halving rounded up, once for each octave left.
    const int scale = 1 << (octave - 1);
    const cv::Size finer((image.width + scale - 1) / scale, (image.height + scale - 1) / scale);
    field.dx = UpsampleDisparity(field.dx, finer);
    field.dy = UpsampleDisparity(field.dy, finer);
    field.confidence = UpsampleNearest(field.confidence, finer);
    field.valid = UpsampleNearest(field.valid, finer);
  }
}

}  // namespace

V1ClosedFormEstimator::V1ClosedFormEstimator(const ClosedFormConfig& config,
                                             std::string_view kernels)
    : config_(Checked(config)),
      bank_(config),
      kernels_(SelectKernels(kernels)),
      there_(config, bank_, kernels_),
      back_(config, bank_, kernels_) {}

SearchBounds V1ClosedFormEstimator::Bounds(bool use_prior) const {
  const double x = config_.search_x_px, y = config_.search_y_px;
  if (!use_prior) return {-x, x, -y, y};
  const EpipolarPrior::Bounds& known = prior_->bounds();
  return {std::clamp(known.low_x, -x, x), std::clamp(known.high_x, -x, x),
          std::clamp(known.low_y, -y, y), std::clamp(known.high_y, -y, y)};
}

DisparityField V1ClosedFormEstimator::Match(cv::Size image, bool use_prior,
                                            hardware::StageTimes* times) {
  const bool check = config_.left_right_px > 0;
  DisparityField field;
  hardware::MeasureIf(times, "coarse to fine", [&] {
    const SearchBounds b = Bounds(use_prior);
    const SearchBounds reversed{-b.high_x, -b.low_x, -b.high_y, -b.low_y};
    Both(
        check, [&] { there_.Run(left_, right_, b, field); },
        [&] { back_.Run(right_, left_, reversed, reverse_); });
  });
  hardware::MeasureIf(times, "checks", [&] {
    const double pixel = 1 << config_.finest_octave;
    InvalidateOutside(field);
    if (check) CheckLeftRight(reverse_, config_.left_right_px / pixel, field);
    if (config_.min_segment_px > 1) {
      InvalidateSmallSegments(static_cast<int>(config_.min_segment_px / (pixel * pixel)),
                              config_.segment_step_px / pixel, field);
    }
  });
  hardware::MeasureIf(times, "enlarge", [&] { Enlarge(config_.finest_octave, image, field); });
  return field;
}

DisparityField V1ClosedFormEstimator::Estimate(const cv::Mat& left, const cv::Mat& right,
                                               hardware::StageTimes* times) {
  CheckPair(left, right);
  hardware::MeasureIf(times, "simple cells", [&] {
    const auto build = [this](ViewPyramid& view, const cv::Mat& image) {
      view.Build(image, config_.search_octave + 1, config_.finest_octave, bank_, kernels_);
    };
    tbb::parallel_invoke([&] { build(left_, left); }, [&] { build(right_, right); });
  });
  const bool use_prior = prior_ && prior_->known();
  DisparityField field = Match(left.size(), use_prior, times);
  prior_contradicted_ = use_prior && prior_->ShareRejected(field) > kMaxContradicted;
  if (prior_contradicted_) {
    field = Match(left.size(), false, times);
  } else if (use_prior) {
    prior_->Reject(field);
  }
  BlankInvalid(field);
  if (config_.fill_in) {
    hardware::MeasureIf(times, "fill-in", [&] { FillIn(left, {}, field); });
  }
  return field;
}

}  // namespace horopter::vision
