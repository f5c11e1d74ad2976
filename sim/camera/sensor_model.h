// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "hardware/types/config_error.h"
#include "hardware/types/eye.h"

namespace horopter::sim {

/// What a sensor adds to a perfect image, in 8-bit grey levels (DN).
///
/// Noise of one channel at signal s has the variance read_noise_dn^2 + shot_gain_dn * s: read noise
/// is the same everywhere, photon shot noise grows with the signal (Poisson, in the Gaussian limit
/// that holds for the hundreds of electrons a grey level stands for).
struct SensorProfile {
  std::string name = "ideal";
  double read_noise_dn = 0;
  double shot_gain_dn = 0;

  std::vector<hardware::FieldError> Validate() const;

  /// "ideal" (no noise) or "webcam_vga" (sigma 1.5 DN in the dark, 3.0 at mid-grey, 4.0 at white:
  /// the range of the noise that facts for webcams give, sigma 1 to 3).
  /// @throws hardware::ConfigError for any other name, listing those known.
  static SensorProfile Named(std::string_view name);
  static std::vector<std::string> Names();
};

/// Turns a rendered image into what the sensor of one eye delivers.
///
/// Noise is a function of (seed, eye, frame number, pixel), so a frame's noise does not depend on
/// which frames were taken before it.
class SensorModel {
 public:
  /// @throws hardware::ConfigError
  SensorModel(const SensorProfile& profile, std::uint64_t seed, hardware::Eye eye);

  /// @param bgr CV_8UC3, changed in place; rounded and clamped to 0..255
  void Apply(std::uint64_t frame, cv::Mat& bgr) const;

 private:
  SensorProfile profile_;
  std::uint64_t stream_;
  std::vector<float> sigma_;  ///< by grey level, 256 entries
};

}  // namespace horopter::sim
