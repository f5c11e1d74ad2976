// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string_view>

#include "hardware/types/camera_model.h"
#include "sim/camera/camera_profile.h"
#include "sim/camera/eye_motion.h"
#include "sim/camera/lens_resampler.h"
#include "sim/camera/row_exposure.h"
#include "sim/camera/sensor_model.h"

namespace horopter::sim {

/// One camera from light to grey levels: which ideal view to render, and what the real camera
/// makes of it.
///
/// An ideal camera costs nothing: its view is its image.
class EyeCamera {
 public:
  /// @param model where points are seen; of the profile's lens only blur and vignetting count here
  /// @param name of the camera; names the streams of its noise
  /// @throws hardware::ConfigError when the profile does not hold or no pinhole covers the view
  EyeCamera(const hardware::CameraModel& model, const CameraProfile& profile, std::uint64_t seed,
            std::string_view name);

  const hardware::CameraModel& model() const { return model_; }
  const RowExposure& exposure() const { return exposure_; }

  /// The size up to which View() may ask, while the eye turns no faster than 10 rad/s; in faster
  /// turns the view gets coarser instead.
  cv::Size largest_view() const { return largest_view_; }

  /// The pinhole camera whose image Develop() needs, at the pose of the instant that `motion` is
  /// about.
  hardware::CameraModel View(const EyeMotion& motion) const;

  /// @param view what View(motion) sees; may be changed, and its pixels become the result's where
  ///        lens and shutter change nothing
  /// @param frame picks the noise
  /// @return CV_8UC3 of the model's size, which nothing else refers to
  cv::Mat3b Develop(cv::Mat3b view, const EyeMotion& motion, std::uint64_t frame);

 private:
  /// Whether the motion moves no pixel by a visible amount while the image is exposed.
  bool Still(const EyeMotion& motion) const;
  /// An image of the model's size that is kept from frame to frame.
  cv::Mat3b Scratch();

  hardware::CameraModel model_;
  RowExposure exposure_;
  double blur_px_;
  SensorModel sensor_;
  bool distorts_;
  LensResampler lens_;
  cv::Size largest_view_;
  std::optional<hardware::CameraModel> still_view_;  ///< set from construction on
  cv::Mat3b scratch_;
};

}  // namespace horopter::sim
