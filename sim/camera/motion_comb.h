// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <opencv2/core/mat.hpp>

namespace horopter::sim {

/// Means of an image and shifted copies of itself, so that a long motion blur needs few samples.
///
/// Level 1 is the mean of two copies one step apart, level 2 that of four. Shifts are whole pixels,
/// which softens nothing across the motion.
class MotionComb {
 public:
  static constexpr int kLevels = 3;
  static constexpr int Taps(int level) { return 1 << level; }

  /// @param view the image, which must outlive the use of level 0
  /// @param step_px from one copy to the next, about 1.5 px long
  /// @param levels how many levels to make, 1 (the view alone) to kLevels. Keeps its memory.
  void Make(const cv::Mat3b& view, const Eigen::Vector2d& step_px, int levels);

  /// Lets go of the view; level 0 is gone.
  void ForgetView() { images_[0].release(); }

  int levels() const { return levels_; }
  const cv::Mat3b& image(int level) const { return images_[level]; }
  /// From the first to the last copy: what a level shows at p is the mean from p to p + extent.
  Eigen::Vector2d Extent(int level) const;
  /// Of the copies' places, summed over both axes [px^2].
  double Variance(int level) const;

 private:
  int levels_ = 1;
  std::array<cv::Mat3b, kLevels> images_;
  std::array<Eigen::Vector2i, kLevels> shifts_{};  ///< that made a level from the one below
};

}  // namespace horopter::sim
