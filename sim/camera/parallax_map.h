// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

namespace horopter::sim {

/// What a ray from beside a view's optical centre hits, as far as the view shows it.
///
/// A ray (x, y, 1) from the centre p_VC, turned by R_VC, hits a point at the inverse depth w along
/// it; the view V sees it at the pixel H (x, y, 1) + w e, with H = K R_VC and e = K p_VC. Of
/// several points that the view shows on the ray, the nearest is hit. Where the view shows none,
/// since something nearer hides it, w is such that the pixel lies beside the edge of what hides it:
/// the background goes on as it is there.
class ParallaxMap {
 public:
  /// @param depth of the view, along its optical z axis [m]; +inf = nothing there
  /// @param farthest_m no ray will come from farther off the view's centre
  /// @param focal_px of the view. Keeps its memory.
  void Make(const cv::Mat1f& depth, double farthest_m, double focal_px);

  /// Inverse depths w along the rays of a row [1/m].
  /// @param x, y, w of `width` values
  void Solve(const Eigen::Matrix3f& H, const Eigen::Vector3f& e, const float* x, const float* y,
             int width, float* w) const;

 private:
  float At(const cv::Mat1f& map, float u, float v) const;

  double focal_px_ = 1;
  cv::Mat1f inverse_;  ///< inverse depths [1/m]
  cv::Mat1f nearest_;  ///< the largest within the reach of the parallax
};

}  // namespace horopter::sim
