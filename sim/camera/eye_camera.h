// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "hardware/types/camera_model.h"
#include "sim/camera/camera_profile.h"
#include "sim/camera/eye_motion.h"
#include "sim/camera/lens_resampler.h"
#include "sim/camera/row_exposure.h"
#include "sim/camera/sensor_model.h"
#include "sim/camera/view_plan.h"

namespace horopter::sim {

/// One camera from light to grey levels: which ideal view to render, and what the real camera
/// makes of it.
///
/// An ideal camera costs nothing: its view is its image. Where a lens both distorts and blurs, the
/// view may be up to as much coarser than the image's middle as leaves it as many pixels as the
/// image, but for its margins, while what is lost would have a contrast of 0.3 at most.
class EyeCamera {
 public:
  /// @param model where points are seen; of the profile's lens only blur and vignetting count here
  /// @param name of the camera; names the streams of its noise
  /// @throws hardware::ConfigError when the profile does not hold or no pinhole covers the view
  EyeCamera(const hardware::CameraModel& model, const CameraProfile& profile, std::uint64_t seed,
            std::string_view name);

  const hardware::CameraModel& model() const { return model_; }
  const RowExposure& exposure() const { return exposure_; }

  /// The size up to which Views() may ask, while the eye turns no faster than 10 rad/s and moves no
  /// faster than 1 m/s; in faster motion the views get coarser instead.
  cv::Size largest_view() const { return largest_view_; }

  /// The views that Develop() needs. One at the instant that `motion` is about, unless the optical
  /// centre moves while a shutter runs: then one for each interlaced field, or for each band of
  /// rows at the instant of its middle, in which what is 0.5 m away shifts by at most 1 px up to
  /// either end (in very fast motion by more: there are at most 16 bands).
  std::vector<ViewPlan> Views(const EyeMotion& motion) const;

  /// The pinhole camera of the one view that is needed when the optical centre rests.
  hardware::CameraModel View(const EyeMotion& motion) const;

  /// @param plans Views(motion)
  /// @param views what the cameras of the plans see from motion.PoseAt() of their instants, in the
  ///        world of the instant that `motion` is about; may be changed; memory that nobody
  ///        else refers to may become the result's, and does where lens and shutter change nothing
  /// @param frame picks the noise
  /// @param light share of it that reaches the sensor
  /// @return CV_8UC3 of the model's size, which nothing else refers to
  cv::Mat3b Develop(const std::vector<ViewPlan>& plans, std::vector<LensView> views,
                    const EyeMotion& motion, std::uint64_t frame, double light = 1);

  /// Likewise from the one view that View(motion) sees.
  cv::Mat3b Develop(cv::Mat3b view, const EyeMotion& motion, std::uint64_t frame);

 private:
  /// Whether the motion moves no pixel by a visible amount while the image is exposed.
  bool Still(const EyeMotion& motion) const;
  /// Rows and instant of each view.
  struct Band {
    RowBand rows;
    double t_s;
  };
  std::vector<Band> Bands(double parallax_px) const;
  /// What falls on the sensor. The result, and scratch_, may lie in the views' memory.
  cv::Mat3b Focus(const std::vector<ViewPlan>& plans, const std::vector<LensView>& views,
                  const EyeMotion& motion);
  void Blur(const cv::Mat3b& sharp, cv::Mat3b& image) const;

  hardware::CameraModel model_;
  RowExposure exposure_;
  double blur_px_;
  SensorModel sensor_;
  bool distorts_;
  LensResampler lens_;
  double view_scale_;  ///< of the views' focal length to the model's
  cv::Size largest_view_;
  std::optional<hardware::CameraModel> still_view_;  ///< set from construction on
  cv::Mat3b scratch_;  ///< an image that nobody else has, kept from frame to frame
};

}  // namespace horopter::sim
