// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

namespace horopter::vision {

/// How much smaller each level of a pyramid is than the one before.
enum class PyramidStep {
  /// 2: [1 4 6 4 1]/16 and every second pixel. Burt & Adelson 1983; the model of 2009.
  kOctave,
  /// sqrt(2): linear interpolation whose weights reach as far as a coarse pixel does, a triangle of
  /// half width sqrt(2). Two such steps blur by the deviation of one octave's binomial. The model
  /// of 2018, which leaves less than half an octave between what two levels measure.
  kHalfOctave
};

/// Levels for each halving of the image's side.
constexpr int LevelsPerOctave(PyramidStep step) { return step == PyramidStep::kOctave ? 1 : 2; }

/// 2 or sqrt(2): pixel (x, y) of a level lies on (factor x, factor y) of the one before.
double LevelFactor(PyramidStep step);

/// Levels of an image, full size first; a level is as large as fits onto the one before, so that
/// its last pixels lie on or within that one's. Borders are replicated.
/// @param scales at most this many, and no level beyond the first with a side below min_side_px
std::vector<cv::Mat1f> BuildPyramid(const cv::Mat1f& image, int scales, int min_side_px,
                                    PyramidStep step = PyramidStep::kOctave);

/// A disparity component of a level as the next finer one sees it: larger by the factor, bilinear.
cv::Mat1f UpsampleDisparity(const cv::Mat1f& coarse, cv::Size fine,
                            PyramidStep step = PyramidStep::kOctave);

/// Whatever a pixel of a level carries, for the nearest pixels of the next finer one.
cv::Mat UpsampleNearest(const cv::Mat& coarse, cv::Size fine,
                        PyramidStep step = PyramidStep::kOctave);

}  // namespace horopter::vision
