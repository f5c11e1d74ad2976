// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "vision/disparity/cell_image.h"
#include "vision/disparity/disparity_field.h"
#include "vision/disparity/edge_map.h"
#include "vision/disparity/view_pyramid.h"

namespace horopter::vision {

/// Disparities at full size among which the coarsest octave's compete [px].
struct SearchBounds {
  double low_x, high_x, low_y, high_y;
};

/// The closed form's way from coarse to fine, in one direction: hypotheses of disparity compete by
/// their pooled binocular correlation, and the winners move by the phases of their pooled products.
///
/// 1. At the coarsest octave every disparity of the range competes.
/// 2. At each octave the pixel's own hypothesis competes with those of neighbours near and far, at
///    some also with all disparities of the field's range.
/// 3. The field is smoothed where it is smooth, and moved by the intersection of constraints.
///
/// Keeps its buffers from run to run; rows and column blocks run in parallel, and the result does
/// not depend on how many threads there are.
class CandidateSearch {
 public:
  /// @param bank, kernels outlive this
  CandidateSearch(const ClosedFormConfig& config, const CellBank& bank,
                  const ClosedFormKernels& kernels);

  /// The field from one view to the other. Every pixel has a disparity and a confidence: the pooled
  /// correlation of its last competition, 0 to 1; `valid` is 255 where it reaches min_coherence.
  /// It has the size of the views' finest octave that has cells, and its pixels as unit.
  /// @param from, to of the same sizes, with cells
  void Run(const ViewPyramid& from, const ViewPyramid& to, const SearchBounds& bounds,
           DisparityField& field);

 private:
  /// One disparity map, for each pixel.
  struct Map {
    PaddedMap<float> dx, dy;
    void Resize(int width, int height);
  };

  /// Whole disparities of an octave, ends included.
  struct Range {
    int low_x, high_x, low_y, high_y;
  };

  /// What a hypothesis is: the disparity of a pixel nearby, or none of it, and something added.
  struct Origin {
    int from_x, from_y;  ///< relative to the pixel
    float add_x, add_y;
    bool of_x, of_y;  ///< added to that pixel's disparity, or alone
  };

  void Enter(const ViewOctave& from, const ViewOctave& to);
  void SearchEverything(int octave, const SearchBounds& bounds);
  void SearchRange(const Range& range);
  /// Where the better half of the winners lie, and a little more: searching there alone leaves out
  /// the false matches that a wide range invites.
  Range Likely(const Range& range);
  float SampleQuantile(double share);
  void Double(int from_width, int from_height);
  void Explore();
  void CompeteWithNeighbours(bool try_steps);
  void Compete(const Candidates& candidates, bool first);
  void CompeteShifts(int first_dx, int last_dx, int move_y, bool from_field, bool first);
  void Refine();
  void Smooth();
  void Median();
  void TakeWinners();
  void QuantiseHypotheses();
  /// Lanes of every row by `fill(y)`, pooled along the row and down the columns.
  template <typename Fill>
  void FillLanes(const PoolingWeights& weights, Fill fill);
  KeepTask Keep(bool first);
  ColumnPool Columns(const PoolingWeights& weights);
  template <typename Loop>
  void ForRows(Loop loop) const;
  template <typename Loop>
  void ForColumns(Loop loop) const;

  ClosedFormConfig config_;
  const CellBank& bank_;
  const ClosedFormKernels& kernels_;
  PoolingWeights score_weights_, product_weights_;

  // Of the octave under way.
  const ViewOctave* from_ = nullptr;
  const ViewOctave* to_ = nullptr;
  int width_ = 0;
  int height_ = 0;
  Map field_, other_;
  PaddedMap<std::int16_t> hypothesis_x_, hypothesis_y_, best_, lanes_;
  /// Who leads the competition under way: an index into origins_, which has one for every lane so
  /// far.
  PaddedMap<std::int32_t> winner_;
  std::vector<Origin> origins_;
  std::vector<float> sample_;
  std::vector<std::int16_t> scores_;
};

}  // namespace horopter::vision
