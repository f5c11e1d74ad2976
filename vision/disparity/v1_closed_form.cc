// SPDX-License-Identifier: Apache-2.0
#include "vision/disparity/v1_closed_form.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <stdexcept>
#include <string>

#include "vision/disparity/enlarge_field.h"
#include "vision/disparity/fill_in.h"
#include "vision/disparity/image_pair.h"
#include "vision/disparity/left_right_check.h"
#include "vision/disparity/noise_level.h"
#include "vision/disparity/small_segments.h"

namespace horopter::vision {
namespace {

ClosedFormConfig Checked(const ClosedFormConfig& config) {
  hardware::ThrowIfAny(config.Validate());
  return config;
}

std::string Text(cv::Size size) {
  return std::to_string(size.width) + "x" + std::to_string(size.height) + " px";
}

/// An image too large is an error, not the end of the process by lack of memory.
void RequireMemory(cv::Size size) {
  constexpr double kMbPerPixel = 260e-6, kMostMb = 8000;
  const double needed_mb = kMbPerPixel * size.width * size.height;
  if (needed_mb <= kMostMb) return;
  throw std::invalid_argument("v1 takes " + std::to_string(static_cast<int>(needed_mb)) +
                              " MB for " + Text(size) + ", and no more than " +
                              std::to_string(static_cast<int>(kMostMb)) +
                              " are allowed: use smaller images");
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

void V1ClosedFormEstimator::Respond(const cv::Mat& left, const cv::Mat& right) {
  const int octaves = config_.search_octave + 1;
  tbb::parallel_invoke([&] { left_.Build(left, octaves); }, [&] { right_.Build(right, octaves); });
  // One of both, so that the octaves correspond.
  const double noise = std::max(left_.noise_grey(), right_.noise_grey());
  const double most =
      config_.max_noise_to_texture * std::min(left_.texture_grey(), right_.texture_grey());
  int finest = config_.finest_octave;
  while (finest + 1 < left_.size() && NoiseAtOctave(noise, finest) > most) ++finest;
  tbb::parallel_invoke([&] { left_.Respond(finest, noise, bank_, kernels_); },
                       [&] { right_.Respond(finest, noise, bank_, kernels_); });
}

DisparityField V1ClosedFormEstimator::Match(bool use_prior, hardware::StageTimes* times) {
  const bool check = config_.left_right_px > 0;
  const int finest = left_.finest();
  DisparityField field;
  hardware::MeasureIf(times, "coarse to fine", [&] {
    const SearchBounds b = Bounds(use_prior);
    const SearchBounds reversed{-b.high_x, -b.low_x, -b.high_y, -b.low_y};
    Both(
        check, [&] { there_.Run(left_, right_, b, field); },
        [&] { back_.Run(right_, left_, reversed, reverse_); });
  });
  hardware::MeasureIf(times, "checks", [&] {
    const double pixel = 1 << finest;
    InvalidateOutside(field);
    if (check) CheckLeftRight(reverse_, config_.left_right_px / pixel, field);
    if (config_.min_segment_px > 1) {
      InvalidateSmallSegments(static_cast<int>(config_.min_segment_px / (pixel * pixel)),
                              config_.segment_step_px / pixel, field);
    }
  });
  if (finest == 0) return field;
  hardware::MeasureIf(times, "enlarge", [&] {
    for (int octave = finest - 1; octave >= 0; --octave) DoubleField(left_[octave].colour, field);
    InvalidateOutside(field);
  });
  return field;
}

DisparityField V1ClosedFormEstimator::MatchByPrior(hardware::StageTimes* times) {
  const auto matched = [](const DisparityField& f) { return cv::countNonZero(f.valid); };
  DisparityField field = Match(true, times);
  prior_contradicted_ = prior_->ShareRejected(field) > kMaxContradicted;
  const double pixels = static_cast<double>(field.valid.total());
  if (prior_contradicted_ || matched(field) < kMinMatched * pixels) {
    DisparityField without =
        hardware::MeasureIf(times, "without prior", [&] { return Match(false, nullptr); });
    prior_contradicted_ |= matched(without) > kMatchedMore * matched(field);
    if (prior_contradicted_) return without;
  }
  prior_->Reject(field);
  return field;
}

DisparityField V1ClosedFormEstimator::Estimate(const cv::Mat& left, const cv::Mat& right,
                                               hardware::StageTimes* times) {
  CheckPair(left, right);
  RequireMemory(left.size());
  if (prior_ && prior_->size() != left.size()) {
    throw std::invalid_argument("epipolar prior: its left camera has " + Text(prior_->size()) +
                                ", the images " + Text(left.size()));
  }
  hardware::MeasureIf(times, "simple cells", [&] { Respond(left, right); });
  prior_contradicted_ = false;
  DisparityField field = prior_ && prior_->known() ? MatchByPrior(times) : Match(false, times);
  BlankInvalid(field);
  if (config_.fill_in) {
    hardware::MeasureIf(times, "fill-in", [&] { FillIn(left, {}, field); });
  }
  return field;
}

}  // namespace horopter::vision
