// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>
#include <opencv2/core/mat.hpp>

#include "hardware/types/camera_model.h"
#include "sim/camera/eye_motion.h"
#include "sim/camera/lens_map.h"
#include "sim/camera/row_exposure.h"

namespace horopter::sim {

/// Resamples the image of a pinhole camera into that of a real one whose eye turns while it looks:
/// lens distortion, pixel shape, and for each row the rotation of the instants at which it is
/// exposed.
///
/// Exact for an eye that turns about its optical centre in a scene at rest: one image then holds
/// every direction's colour. Neglected within one image: that the optical centre moves (off-axis
/// eyes, a driving base) and that things move by themselves.
class LensResampler {
 public:
  /// @throws hardware::ConfigError, as LensMap
  LensResampler(const hardware::CameraModel& camera, const RowExposure& exposure);

  const hardware::CameraModel& camera() const { return map_.camera(); }
  const LensMap& map() const { return map_; }

  /// What is seen by any row at any instant of its exposure.
  TanBounds Bounds(const EyeMotion& motion) const;

  /// @param view what `pinhole` saw at the instant that `motion` is about
  /// @param image of the camera's size, CV_8UC3, overwritten
  void Resample(const cv::Mat3b& view, const hardware::CameraModel& pinhole,
                const EyeMotion& motion, cv::Mat3b& image) const;

 private:
  /// How many instants of a row's exposure are averaged: no farther apart than 1.5 pixels, which
  /// still cancels the finest pattern that an image can hold.
  int Instants(int row, const Eigen::Matrix3d& K, const EyeMotion& motion) const;

  LensMap map_;
  RowExposure exposure_;
};

}  // namespace horopter::sim
