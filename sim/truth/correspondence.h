// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>

#include "sim/truth/ground_truth.h"
#include "sim/truth/scene_snapshot.h"

namespace horopter::sim {

/// What becomes of a pixel of one view in another.
enum class Visibility : std::uint8_t {
  kNoSurface,  ///< the first view sees nothing there
  kVisible,
  kOccluded,   ///< it would be in the other image, but something nearer covers it, or it faces away
  kOutOfView,  ///< it falls outside the other image, behind that eye, or nearer than it can see
};

/// Where the surface points at one view's pixel centres lie in another view: what the first image
/// shows at (x, y) lies at (x + dx, y + dy) in the other, the convention of vision::DisparityField.
/// All maps have the size of the first view.
struct CorrespondenceField {
  cv::Mat1f dx;  ///< [px], also where occluded or out of view; NaN = no surface, or no projection
  cv::Mat1f dy;
  cv::Mat1b visibility;  ///< of type Visibility

  Visibility at(int y, int x) const { return static_cast<Visibility>(visibility(y, x)); }
  /// 255 where the pixel's visibility is `which`, else 0.
  cv::Mat1b Mask(Visibility which) const;
};

/// The general case: from what an eye saw at one instant to what an eye sees at another. Each point
/// moves with the geom that it is on.
///
/// Points are found again in double precision and held against the other instant's geometry by a
/// ray from the other eye, so displacement and visibility are exact for the pixel's centre,
/// whatever the two cameras are: verged, tilted, rolled, of different focal lengths, distorted. Two
/// surfaces within 1e-7 of their depth count as one.
/// @param from seen in `from_scene` (CaptureEyeTruth)
/// @param to_scene of the same shapes as `from_scene`
CorrespondenceField TrueCorrespondence(const SceneSnapshot& from_scene, const EyeTruth& from,
                                       const SceneSnapshot& to_scene, const EyeView& to);

/// Vector disparity between two eyes of one instant; either may be the left.
inline CorrespondenceField TrueDisparity(const SceneSnapshot& scene, const EyeTruth& from,
                                         const EyeView& to) {
  return TrueCorrespondence(scene, from, scene, to);
}

/// Optical flow of one camera from an earlier instant to a later (or the reverse), with eyes and
/// objects moving.
inline CorrespondenceField TrueFlow(const SceneSnapshot& then, const EyeTruth& seen_then,
                                    const SceneSnapshot& now, const EyeView& view_now) {
  return TrueCorrespondence(then, seen_then, now, view_now);
}

}  // namespace horopter::sim
