// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "hardware/types/camera_model.h"
#include "hardware/types/pose.h"
#include "vision/disparity/disparity_field.h"

namespace horopter::vision {

/// The relative pose of the eyes, as encoders or a calibration give it, and how well it is known.
struct RelativePose {
  hardware::Pose X_ClCr = hardware::Pose::Identity();
  /// Of a small rotation [rad] and translation [m], both in Cl, that come before X_ClCr.
  Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();
};

struct EpipolarPriorConfig {
  /// Nothing is nearer to the left eye.
  double min_depth_m = 0.15;
  /// Deviations of the pose that count as possible.
  double sigmas = 3;
  /// What a match may be off by itself [px].
  double slack_px = 1.5;

  /// Every field that does not hold.
  std::vector<hardware::FieldError> Validate() const;
};

/// The disparities that a relative pose allows: for each pixel of the left image a piece of its
/// epipolar line, from infinity to min_depth_m, as wide as the pose's uncertainty makes it.
///
/// Known at every eighth pixel and interpolated between; disparities change smoothly over an image.
/// Works for verged, tilted and rolled eyes, different focal lengths and lens distortion. Where a
/// line is not seen by the right eye nothing is known, and nothing rejected.
class EpipolarPrior {
 public:
  /// @throws ConfigError for a bad config; std::invalid_argument for a covariance that is none
  EpipolarPrior(const hardware::CameraModel& left, const hardware::CameraModel& right,
                const RelativePose& pose, const EpipolarPriorConfig& config = {});

  /// All disparities allowed anywhere in the image [px], uncertainty included.
  struct Bounds {
    double low_x, high_x, low_y, high_y;
  };
  /// @pre known()
  const Bounds& bounds() const { return bounds_; }
  /// Whether anything is known of any pixel.
  bool known() const { return bounds_.low_x <= bounds_.high_x; }

  /// Of the left camera's images.
  cv::Size size() const { return size_; }

  /// Whether a disparity is allowed at a pixel.
  /// @pre it lies in the left camera's image
  bool Allows(int x, int y, float dx, float dy) const;

  /// The share of a field's valid pixels that is not allowed; 0 where none is valid. A large share
  /// says that the pose is wrong, not the matches.
  /// @pre the field has the left camera's size
  double ShareRejected(const DisparityField& field) const;

  /// Clears `valid` where a disparity is not allowed.
  void Reject(DisparityField& field) const;

 private:
  /// What a pixel's line looks like: its ends, as disparities, and the deviation across it.
  struct Line {
    Eigen::Vector2d far, near;
    double sigma_px = 0;
    bool known = false;
  };
  Line LineOf(const hardware::CameraModel& left, const hardware::CameraModel& right,
              const RelativePose& pose, const Eigen::Vector2d& pixel) const;
  void Extend(const Line& line);
  cv::Mat1b Contradicted(const DisparityField& field) const;

  EpipolarPriorConfig config_;
  cv::Size size_;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<Line> lines_;
  Bounds bounds_;
};

}  // namespace horopter::vision
