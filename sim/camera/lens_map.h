// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <limits>
#include <opencv2/core/mat.hpp>

#include "hardware/types/camera_model.h"

namespace horopter::sim {

/// A rectangle on the plane z = 1 of an optical frame: tangents to the right and down.
struct TanBounds {
  Eigen::Array2d low = Eigen::Array2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Array2d high = -low;

  void Include(const Eigen::Array2d& tangents) {
    low = low.min(tangents);
    high = high.max(tangents);
  }
  void Include(const TanBounds& other) {
    low = low.min(other.low);
    high = high.max(other.high);
  }
};

/// Where each pixel of a camera looks: the point of its ray on the plane z = 1.
class LensMap {
 public:
  /// @throws hardware::ConfigError when no ray reaches some pixel, since the distortion folds
  ///         inside the image, or when one lies farther than 85 deg off the axis
  explicit LensMap(const hardware::CameraModel& camera);

  const hardware::CameraModel& camera() const { return camera_; }
  /// Of one row: as many values as the image is wide, rounded up for BilinearRow.
  const float* x(int row) const { return x_[row]; }
  const float* y(int row) const { return y_[row]; }
  Eigen::Vector3f Ray(int row, int column) const {
    return {x_(row, column), y_(row, column), 1.0F};
  }
  const TanBounds& bounds() const { return bounds_; }
  /// Pixels of a pinhole image with the camera's larger focal length that one pixel takes up, in
  /// the mean: above 1 where the lens is coarser off its axis.
  double PixelsPerPixel() const;

 private:
  hardware::CameraModel camera_;
  cv::Mat1f x_;
  cv::Mat1f y_;
  TanBounds bounds_;
};

/// The camera from whose image another's is resampled: square pixels, no distortion, and all of
/// `bounds` at least one pixel inside the image. Its focal length is the larger one of `camera`
/// times `scale`, and at a scale of 1 its pixels lie on those of `camera` where the lens distorts
/// nothing; when that needs more than `largest`, it is shorter, and the image softer.
hardware::CameraModel CoveringPinhole(const hardware::CameraModel& camera, const TanBounds& bounds,
                                      cv::Size largest, double scale = 1);

}  // namespace horopter::sim
