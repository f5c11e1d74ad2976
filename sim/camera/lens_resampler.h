// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <opencv2/core/mat.hpp>

#include "hardware/types/camera_model.h"
#include "sim/camera/eye_motion.h"
#include "sim/camera/lens_map.h"
#include "sim/camera/motion_comb.h"
#include "sim/camera/parallax_map.h"
#include "sim/camera/row_exposure.h"
#include "sim/camera/view_plan.h"

namespace horopter::sim {

/// Resamples views of pinhole cameras into the image of a real one whose eye turns and moves while
/// it looks: lens distortion, pixel shape, and for each row the poses at which it is exposed.
///
/// Where the optical centre rests, one view holds every direction's colour. Where it moves, a view
/// is taken near each row's instant (PlanViews) and its depth says what the row's rays hit: within
/// 0.1 px of an image rendered for every row, but for gaps of at most 2 px beside the edges of what
/// is nearer than 0.5 m, which the background fills. A long motion blur takes its samples from a
/// MotionComb, whose copies lie within half a pixel of their places, and everything blurs along the
/// way of what its pixel shows in the middle of the row's exposure. Neglected within one image:
/// that things move by themselves.
class LensResampler {
 public:
  /// @throws hardware::ConfigError, as LensMap
  LensResampler(const hardware::CameraModel& camera, const RowExposure& exposure);

  const hardware::CameraModel& camera() const { return map_.camera(); }
  const LensMap& map() const { return map_; }
  RowBand AllRows() const { return {0, camera().height(), 1}; }

  /// What is seen by any of the rows at any instant of its exposure, at 0.2 m or farther.
  /// @param motion as seen from the view's place
  TanBounds Bounds(const RowBand& rows, const EyeMotion& motion) const;

  /// How far from the view's the optical centre is at most, in the middle of a row's exposure [m].
  double FarthestCentre(const RowBand& rows, const EyeMotion& motion) const;

  /// @param view what the plan's camera saw from where `motion` was at the plan's instant
  /// @param image of the camera's size, CV_8UC3, whose rows of the plan are overwritten. One call
  ///        at a time.
  void Resample(const ViewPlan& plan, const LensView& view, const EyeMotion& motion,
                cv::Mat3b& image) const;

 private:
  /// How one row is summed up: from which level of the comb, at how many instants, spread over
  /// which share of the exposure.
  struct RowPlan {
    int level = 0;
    int instants = 1;
    double share = 1;
  };
  /// A row with what its rays hit: inverse depths, or null.
  struct Row {
    int y;
    const float* w;
  };

  /// The ways, in the view, of a row's first, middle and last pixel during its exposure [px].
  using Ways = std::array<Eigen::Vector2d, 3>;
  static constexpr int kMiddle = 1;
  Ways WaysOf(const Row& row, const Eigen::Matrix3d& K, const EyeMotion& motion) const;
  /// How many instants a row's exposure needs: no farther apart than 1.75 pixels, which still
  /// cancels the finest pattern that an image can hold.
  static int Instants(const Ways& ways);
  RowPlan Plan(const Ways& ways) const;
  /// Inverse depths along the row's rays in the middle of its exposure.
  void SolveParallax(int y, const Eigen::Matrix3d& K, const EyeMotion& motion, float* w) const;
  void MakeComb(const ViewPlan& plan, const LensView& view, const Eigen::Matrix3d& K,
                const EyeMotion& motion) const;

  LensMap map_;
  RowExposure exposure_;
  mutable MotionComb comb_;       ///< memory kept from frame to frame
  mutable ParallaxMap parallax_;  ///< likewise
};

}  // namespace horopter::sim
