// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>

#include "sim/truth/ground_truth.h"

namespace horopter::sim {

/// What becomes of a left pixel in the right image.
enum class Visibility : std::uint8_t {
  kNoSurface,  ///< the left eye sees nothing there
  kVisible,
  kOccluded,   ///< something nearer covers the point in the right image
  kOutOfView,  ///< the point falls outside the right image, or behind the right eye
  kEdge,       ///< within a pixel of an edge in the right image: sampled depth cannot tell
};

/// Exact vector disparity of every left pixel's centre, in the convention of
/// vision::DisparityField: what the left image shows at (x, y) lies at (x + dx, y + dy) in the
/// right. All maps have the size of the left image.
struct TrueDisparityField {
  cv::Mat1f dx;  ///< [px], also where occluded or out of view; NaN = no surface, or behind the eye
  cv::Mat1f dy;
  cv::Mat1b visibility;  ///< of type Visibility

  Visibility at(int y, int x) const { return static_cast<Visibility>(visibility(y, x)); }
  /// 255 where the pixel's visibility is `which`, else 0.
  cv::Mat1b Mask(Visibility which) const;
};

/// Disparity by projecting each left pixel's surface point into the right eye: any verged, rolled
/// or mixed-field-of-view pair, distorted or not.
///
/// Occlusion compares the point with the four right pixels around its projection. Each of them is
/// held against the tangent plane of the left pixel's surface (1/z is linear in a pixel's ray on a
/// plane, so it is found from neighbours of the same object), so that slant is not mistaken for
/// something nearer; object ids tell apart surfaces that lie close together.
/// @pre the maps of both eyes have the sizes of their camera models
TrueDisparityField TrueDisparity(const EyeTruth& left, const EyeTruth& right);

inline TrueDisparityField TrueDisparity(const GroundTruth& truth) {
  return TrueDisparity(truth.left, truth.right);
}

}  // namespace horopter::sim
