// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "hardware/types/camera_model.h"
#include "hardware/types/config_error.h"
#include "hardware/types/eye.h"
#include "hardware/types/head_angles.h"
#include "hardware/types/pose.h"
#include "vision/disparity/disparity_field.h"
#include "vision/reconstruction/equation_two.h"
#include "vision/reconstruction/point_field.h"

namespace horopter::vision {

struct ReconstructionConfig {
  /// Rays that meet at a smaller angle give no point: their distance would be noise. The default
  /// is a third of a pixel of a 60 degree VGA image.
  double min_parallax_rad = 6e-4;

  std::vector<hardware::FieldError> Validate() const;
};

/// 3D points from vector disparity and any pan and tilt of each eye, without rectification: the
/// 4x3 least squares of equation (2) of Chessa et al. 2014 for every pixel of the left image.
///
/// Lens distortion and principal point are taken out of both pixels first: exactly for the left
/// one; for the right one, which lies between pixels, by interpolating between exact rays and
/// correcting by where the camera projects the result, which leaves less than 1e-5 px. There is no
/// point (NaN) where the disparity is invalid, the match lies outside the right image, a pixel has
/// no ray, the rays are nearer parallel than the configuration allows, or the solution is not in
/// front of both eyes. `residual_m` is the larger of the point's distances to the two rays.
///
/// Rows run in parallel; each pixel's result depends on that pixel alone, so that it is the same
/// for any number of threads.
class Reconstructor {
 public:
  /// Computes the rays of every pixel once. @throws hardware::ConfigError
  explicit Reconstructor(const hardware::PerEye<hardware::CameraModel>& cameras,
                         const ReconstructionConfig& config = {});

  /// @param angles the eyes' pan and tilt count; the neck does not move the result's frame
  /// @param baseline_m distance of the eyes' axes
  /// @param axis_to_optical_centre_m how far each optical centre is before its axis; 0 in the paper
  /// @return points in the head frame H: midway between the optical centres, body axes
  /// @throws std::invalid_argument when the field's size is not the left camera's, an angle is not
  ///         finite, or the baseline is not positive
  PointField Reconstruct(const DisparityField& disparity, const hardware::HeadAngles& angles,
                         double baseline_m, double axis_to_optical_centre_m = 0) const;

  /// The same for eyes that stand anywhere: X_HC is each optical frame in the frame H of the
  /// result (body axes), for heads whose optical centres lie off the pan axes.
  PointField Reconstruct(const DisparityField& disparity,
                         const hardware::PerEye<hardware::Pose>& X_HC) const;

 private:
  PointField Solve(const DisparityField& disparity, const PaperEye& left,
                   const PaperEye& right) const;

  /// Normalised image point of each pixel, y up.
  struct Rays {
    explicit Rays(const hardware::CameraModel& camera);
    /// NaN outside the image or where there is no ray.
    Eigen::Vector2d At(const Eigen::Vector2d& pixel) const;

    Eigen::Vector2d Interpolated(const Eigen::Vector2d& pixel) const;

    hardware::CameraModel camera;
    cv::Mat_<cv::Vec2d> table;  ///< empty without distortion
  };

  ReconstructionConfig config_;
  Rays left_;
  Rays right_;
};

}  // namespace horopter::vision
