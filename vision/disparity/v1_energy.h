// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "vision/disparity/disparity_estimator.h"
#include "vision/disparity/gabor_bank.h"
#include "vision/disparity/linear_readout.h"
#include "vision/disparity/v1_config.h"
#include "vision/disparity/v1_population.h"

namespace horopter::vision {

/// Vector disparity by the binocular energy model of the primary visual cortex, in the population
/// form: each pixel has orientations x phase shifts energy neurons, their activity is decoded into
/// a vector, and a pyramid extends the reach to +-max_disparity_px * sum of factor^level. As
/// Chessa, Sabatini & Solari (ICVS 2009) have it, the method of the Koala robot, activity is
/// decoded by centre of mass and intersection of constraints (Population); as Chessa & Solari
/// (2018) have it, by a linear readout (LinearReadout).
///
/// Invalid are: pixels without texture at every scale that counts; matches of too little binocular
/// correlation, where the preset asks for any; matches outside the right image; with
/// `left_right_px`, what the reverse direction does not confirm; and, with `min_segment_px`, small
/// islands. With `fill_in` they are filled in instead, and marked. Confidence is the binocular
/// correlation (PopulationDisparity) of the finest scale that saw the pixel, at the start of its
/// last iteration, halved for every octave that this scale is above full size; 0 where filled in.
class V1EnergyEstimator final : public DisparityEstimator {
 public:
  /// @throws ConfigError naming every bad field.
  explicit V1EnergyEstimator(const V1Config& config);

  using DisparityEstimator::Estimate;
  DisparityField Estimate(const cv::Mat& left, const cv::Mat& right,
                          hardware::StageTimes* times) override;
  std::string_view name() const override { return "v1"; }

 private:
  /// Of every level, full size first: simple cells, and grey levels where filling in needs them.
  struct View {
    std::vector<SimpleCellMap> cells;
    std::vector<cv::Mat1b> grey;
  };

  View See(const cv::Mat& image) const;
  DisparityField CoarseToFine(const View& from, const View& to) const;
  /// One scale: moves the field towards where the population sees the match.
  void Refine(const View& from, const View& to, std::size_t level, DisparityField& field) const;
  template <typename Decoder>
  void RefineBy(const Decoder& decoder, const View& from, const View& to, std::size_t level,
                DisparityField& field) const;
  void Pool(cv::Mat& sums) const;

  V1Config config_;
  GaborBank bank_;
  Population population_;
  LinearReadout readout_;
};

}  // namespace horopter::vision
