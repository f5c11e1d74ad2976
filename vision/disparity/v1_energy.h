// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include "vision/disparity/disparity_estimator.h"
#include "vision/disparity/gabor_bank.h"
#include "vision/disparity/v1_config.h"
#include "vision/disparity/v1_population.h"

namespace horopter::vision {

/// Vector disparity by the binocular energy model of the primary visual cortex, in the population
/// form of Chessa, Sabatini & Solari (ICVS 2009), the method of the Koala robot: each pixel has
/// kOrientations x kPhaseShifts energy neurons, their activity is decoded into a vector, and a
/// pyramid extends the reach to +-max_disparity_px * (2^scales - 1).
///
/// Invalid are: pixels without texture at every scale that counts; matches of too little binocular
/// correlation, where the preset asks for any; matches outside the right image; with
/// `left_right_px`, what the reverse direction does not confirm; and, with `min_segment_px`, small
/// islands. Confidence is the binocular
/// correlation (PopulationDisparity) of the finest scale that saw the pixel, at the start of its
/// last iteration, halved for every octave that this scale is above full size.
class V1EnergyEstimator final : public DisparityEstimator {
 public:
  /// @throws ConfigError naming every bad field.
  explicit V1EnergyEstimator(const V1Config& config);

  using DisparityEstimator::Estimate;
  DisparityField Estimate(const cv::Mat& left, const cv::Mat& right,
                          hardware::StageTimes* times) override;
  std::string_view name() const override { return "v1"; }

 private:
  /// Simple cells of every octave, full size first.
  using CellPyramid = std::vector<SimpleCellMap>;

  CellPyramid Filter(const cv::Mat& image) const;
  DisparityField CoarseToFine(const CellPyramid& from, const CellPyramid& to) const;
  /// One scale: moves the field towards where the population sees the match.
  void Refine(const SimpleCellMap& from, const SimpleCellMap& to, int octave,
              DisparityField& field) const;
  /// Constraints of every pixel (a Mat of 8 channels), warped by the field's disparity.
  cv::Mat DecodeAll(const SimpleCellMap& from, const SimpleCellMap& to, int octave,
                    const DisparityField& field) const;

  V1Config config_;
  GaborBank bank_;
  Population population_;
};

}  // namespace horopter::vision
