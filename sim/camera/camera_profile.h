// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "hardware/types/camera_model.h"
#include "hardware/types/config_error.h"

namespace horopter::sim {

/// What the lens does to where and how sharply a point is seen. The default is a perfect pinhole.
struct LensProfile {
  hardware::Distortion distortion;
  /// Where the optical axis meets the sensor, from the image's middle: right and down [px at a
  /// width of 640; scales with the image].
  Eigen::Vector2d principal_point_offset_px = Eigen::Vector2d::Zero();
  double pixel_aspect = 1;  ///< fy / fx, which is a pixel's width over its height
  double blur_px = 0;       ///< standard deviation of the Gaussian point spread function
  /// What is lost at the image's corner, 0 to 1; the loss grows with the square of the distance
  /// from the principal point, which is cos^4 to first order.
  double vignetting = 0;

  /// The camera that this lens makes of an ideal one of a size and field of view (lens distortion
  /// aside). @throws hardware::ConfigError
  hardware::CameraModel Model(int width, int height, double horizontal_fov_rad) const;

  bool operator==(const LensProfile&) const = default;
};

/// How long light is gathered, and how much of it a grey level stands for.
struct ExposureProfile {
  double time_s = 0;  ///< 0: an instant, so that nothing blurs by motion
  double gain = 1;    ///< grey levels are multiplied by it, and clip at 255

  bool operator==(const ExposureProfile&) const = default;
};

/// Noise of one channel at signal s has the variance read_noise_dn^2 + shot_gain_dn * s: read noise
/// is the same everywhere, photon shot noise grows with the signal (Poisson, in the Gaussian limit
/// that holds for the hundreds of electrons a grey level stands for). In 8-bit grey levels (DN).
struct NoiseProfile {
  double read_noise_dn = 0;
  double shot_gain_dn = 0;
  int bits = 8;  ///< levels of the analogue-digital converter: 2^bits from 0 to 255

  bool operator==(const NoiseProfile&) const = default;
};

enum class Shutter {
  kGlobal,      ///< the whole image at once
  kRolling,     ///< rows one after the other, from the top
  kInterlaced,  ///< even rows first, half a frame later the odd ones (a PAL or NTSC camera)
};

/// When the rows of an image are exposed.
struct ShutterProfile {
  Shutter kind = Shutter::kGlobal;
  /// Rolling: from the top row's exposure to the bottom row's. Interlaced: from the even field's to
  /// the odd field's. Global: not used.
  double readout_s = 0;

  bool operator==(const ShutterProfile&) const = default;
};

/// When frames are taken and when they arrive.
struct TimingProfile {
  double rate_hz = 0;             ///< 0: a frame for every physics step
  double latency_s = 0;           ///< from the end of the last row's exposure to delivery
  double capture_jitter_s = 0;    ///< captures are early or late by up to this, uniformly
  double delivery_jitter_s = 0;   ///< deliveries are late by up to this, uniformly
  double drop_probability = 0;    ///< of a frame that never arrives
  double repeat_probability = 0;  ///< of a frame that shows the one before it again
  double skew_s = 0;              ///< the right eye captures this much later than the left

  bool operator==(const TimingProfile&) const = default;
};

/// A kind of camera: what it does to a perfect image. The default does nothing.
///
/// Every part that is random has a stream of its own from the run's seed, so that turning one on
/// changes no other.
struct CameraProfile {
  std::string name = "ideal";
  LensProfile lens;
  ExposureProfile exposure;
  NoiseProfile noise;
  ShutterProfile shutter;
  TimingProfile timing;

  bool operator==(const CameraProfile&) const = default;

  /// Every field that does not hold, as "camera.<part>.<field>".
  std::vector<hardware::FieldError> Validate() const;

  /// Where no data sheet gives a number it is typical of the kind, not measured on a unit:
  /// - "ideal": a pinhole without noise, every instant, at once.
  /// - "vga_noise": the noise of "webcam_vga" and nothing else of it.
  /// - "webcam_vga": a CMOS webcam at 30 Hz. Noise sigma 1.5 DN in the dark, 3 at mid-grey, 4 at
  ///   white; mild barrel distortion; rows read over nearly the whole frame period.
  /// - "lifecam_vx6000": the NAO paper's wide-angle CMOS webcam (71 deg, 30 Hz): stronger barrel
  ///   distortion and vignetting than the former.
  /// - "sony_xc999": the Yorick paper's CCD camera: PAL, 25 Hz, two fields 20 ms apart, each
  ///   exposed for its 20 ms; signal-to-noise ratio 48 dB.
  /// @throws hardware::ConfigError for any other name, listing those known.
  static CameraProfile Named(std::string_view name);
  static std::vector<std::string> Names();
};

}  // namespace horopter::sim
