// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>
#include <utility>

#include "vision/disparity/candidate_search.h"
#include "vision/disparity/closed_form_config.h"
#include "vision/disparity/disparity_estimator.h"
#include "vision/disparity/epipolar_prior.h"
#include "vision/disparity/view_pyramid.h"

namespace horopter::vision {

/// Vector disparity by the binocular energy model in closed form: what V1EnergyEstimator reads from
/// a population of phase-shifted cells is here one complex product for each orientation, and what
/// it decodes at each pixel apart is here found by competition of neighbours' hypotheses.
///
/// Invalid is: what has too little pooled binocular correlation, matches outside the right image,
/// what the reverse direction does not confirm, and small islands. Confidence is the pooled
/// correlation. Disparities of up to +-search_x_px, +-search_y_px are found without any prior.
/// Not for use from two threads at once: buffers are kept from pair to pair.
class V1ClosedFormEstimator final : public DisparityEstimator {
 public:
  /// @throws ConfigError naming every bad field
  /// @param kernels as SelectKernels takes them; "" = the best there are
  explicit V1ClosedFormEstimator(const ClosedFormConfig& config, std::string_view kernels = "");

  V1ClosedFormEstimator(const V1ClosedFormEstimator&) = delete;
  V1ClosedFormEstimator& operator=(const V1ClosedFormEstimator&) = delete;

  using DisparityEstimator::Estimate;
  DisparityField Estimate(const cv::Mat& left, const cv::Mat& right,
                          hardware::StageTimes* times) override;
  std::string_view name() const override { return "v1"; }

  /// What is known of the eyes' pose from now on; nothing is needed. The prior bounds the search
  /// and rejects matches off their epipolar lines, as far as its uncertainty allows. Images are
  /// matched anew without it when more than kMaxContradicted of the matches contradict it, or when
  /// less than kMinMatched of the pixels match; the prior is wrong then if that finds kMatchedMore
  /// times as many. The prior's left camera must have the images' size.
  void SetPrior(std::optional<EpipolarPrior> prior) { prior_ = std::move(prior); }
  static constexpr double kMaxContradicted = 0.5;
  static constexpr double kMinMatched = 0.3;
  static constexpr double kMatchedMore = 1.5;
  /// Whether the last pair contradicted the prior.
  bool prior_contradicted() const { return prior_contradicted_; }

 private:
  SearchBounds Bounds(bool use_prior) const;
  /// Both images' octaves and cells, as fine as their noise allows.
  void Respond(const cv::Mat& left, const cv::Mat& right);
  /// Both directions, checked against each other, at full size.
  DisparityField Match(bool use_prior, hardware::StageTimes* times);
  /// Where the prior is known: by it, or without it where the images speak against it.
  DisparityField MatchByPrior(hardware::StageTimes* times);

  ClosedFormConfig config_;
  CellBank bank_;
  const ClosedFormKernels& kernels_;
  ViewPyramid left_, right_;
  CandidateSearch there_, back_;
  DisparityField reverse_;
  std::optional<EpipolarPrior> prior_;
  bool prior_contradicted_ = false;
};

}  // namespace horopter::vision
