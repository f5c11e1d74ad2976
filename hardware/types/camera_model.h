// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "hardware/types/config_error.h"

namespace horopter::hardware {

/// Pinhole intrinsics in pixels. Pixel (0, 0) is a pixel centre, so a centred principal point is
/// ((width - 1) / 2, (height - 1) / 2).
struct Intrinsics {
  int width = 0;
  int height = 0;
  double fx = 0;
  double fy = 0;
  double cx = 0;
  double cy = 0;
};

/// Brown-Conrady lens distortion in OpenCV's convention and order (k1 k2 p1 p2 k3).
struct Distortion {
  double k1 = 0;
  double k2 = 0;
  double p1 = 0;
  double p2 = 0;
  double k3 = 0;

  bool operator==(const Distortion&) const = default;
  bool any() const { return k1 != 0 || k2 != 0 || p1 != 0 || p2 != 0 || k3 != 0; }
};

/// Maps between points in an optical frame (x right, y down, z forward, metres) and pixels.
///
/// Immutable; every instance holds its invariants: a size of at least 1x1, finite positive focal
/// lengths, a finite principal point and distortion.
class CameraModel {
 public:
  /// @throws ConfigError naming every bad field.
  explicit CameraModel(const Intrinsics& intrinsics, const Distortion& distortion = {});

  /// Square pixels, centred principal point, no distortion.
  /// @param horizontal_fov_rad in (0, pi)
  /// @throws ConfigError
  static CameraModel FromHorizontalFov(int width, int height, double horizontal_fov_rad);

  const Intrinsics& intrinsics() const { return intrinsics_; }
  const Distortion& distortion() const { return distortion_; }
  int width() const { return intrinsics_.width; }
  int height() const { return intrinsics_.height; }
  /// Angle between the image's left and right (top and bottom) edges through the principal point,
  /// lens distortion aside.
  double horizontal_fov_rad() const;
  double vertical_fov_rad() const;

  /// The pixel where a point is seen, which may lie outside the image.
  /// @param p_C point in the optical frame [m]
  /// @return nothing when the point is not in front of the camera (z <= 0 or not finite), or
  ///         beyond the radius where the radial polynomial stops growing.
  std::optional<Eigen::Vector2d> Project(const Eigen::Vector3d& p_C) const;

  /// Direction in the optical frame of what is seen at a pixel, with z = 1.
  /// Inverts the distortion by Newton's method to 1e-12, relative beyond 45 deg; @return nothing
  /// when no direction maps to the pixel.
  std::optional<Eigen::Vector3d> Unproject(const Eigen::Vector2d& pixel) const;

  bool Contains(const Eigen::Vector2d& pixel) const {
    return pixel.x() >= -0.5 && pixel.y() >= -0.5 && pixel.x() < width() - 0.5 &&
           pixel.y() < height() - 0.5;
  }

  /// The same camera without its lens distortion.
  CameraModel Undistorted() const { return CameraModel(intrinsics_); }

 private:
  /// Distorted normalised coordinates of undistorted ones, and optionally the Jacobian.
  Eigen::Vector2d Distort(const Eigen::Vector2d& n, Eigen::Matrix2d* jacobian) const;

  /// Undistorted coordinates whose radial part alone gives `target`, or the nearest there are:
  /// where Newton's method starts, on the right side of the fold.
  Eigen::Vector2d InvertRadial(const Eigen::Vector2d& target) const;

  Intrinsics intrinsics_;
  Distortion distortion_;
  double max_radius2_;  ///< undistorted r^2 up to which the radial polynomial grows
};

}  // namespace horopter::hardware
