// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>
#include <opencv2/core/mat.hpp>

#include "hardware/types/camera_model.h"
#include "sim/camera/eye_motion.h"
#include "sim/camera/lens_map.h"
#include "sim/camera/motion_comb.h"
#include "sim/camera/row_exposure.h"

namespace horopter::sim {

/// Resamples the image of a pinhole camera into that of a real one whose eye turns while it looks:
/// lens distortion, pixel shape, and for each row the rotation of the instants at which it is
/// exposed.
///
/// Exact for an eye that turns about its optical centre in a scene at rest: one image then holds
/// every direction's colour. A long motion blur takes its samples from a MotionComb, whose copies
/// lie within half a pixel of their places. Neglected within one image: that the optical centre
/// moves (off-axis eyes, a driving base) and that things move by themselves.
class LensResampler {
 public:
  /// @throws hardware::ConfigError, as LensMap
  LensResampler(const hardware::CameraModel& camera, const RowExposure& exposure);

  const hardware::CameraModel& camera() const { return map_.camera(); }
  const LensMap& map() const { return map_; }

  /// What is seen by any row at any instant of its exposure.
  TanBounds Bounds(const EyeMotion& motion) const;

  /// @param view what `pinhole` saw at the instant that `motion` is about
  /// @param image of the camera's size, CV_8UC3, overwritten. One call at a time.
  void Resample(const cv::Mat3b& view, const hardware::CameraModel& pinhole,
                const EyeMotion& motion, cv::Mat3b& image) const;

 private:
  /// How one row is summed up: from which level of the comb, at how many instants, spread over
  /// which share of the exposure.
  struct RowPlan {
    int level = 0;
    int instants = 1;
    double share = 1;
  };

  /// The way of a pixel of the view during a row's exposure.
  Eigen::Vector2d Way(int row, int column, const Eigen::Matrix3d& K, const EyeMotion& motion) const;
  /// How many instants a row's exposure needs: no farther apart than 1.75 pixels, which still
  /// cancels the finest pattern that an image can hold.
  int Instants(int row, const Eigen::Matrix3d& K, const EyeMotion& motion) const;
  RowPlan Plan(int row, const Eigen::Matrix3d& K, const EyeMotion& motion,
               const MotionComb& comb) const;

  LensMap map_;
  RowExposure exposure_;
  mutable MotionComb comb_;  ///< memory kept from frame to frame
};

}  // namespace horopter::sim
