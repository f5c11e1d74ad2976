// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <string_view>
#include <vector>

#include "hardware/types/camera_model.h"
#include "sim/camera/camera_profile.h"

namespace horopter::sim {

/// What a sensor makes of the light that falls on it: exposure and vignetting, shot and read noise,
/// clipping and quantisation, in this order. Grey levels are taken to be proportional to light.
///
/// Noise is a function of (seed, camera, kind of noise, frame number, pixel, channel), so a frame's
/// noise does not depend on the frames before it, nor one kind on the other. It is drawn from 4096
/// equally probable values of the normal law, the largest 3.7 standard deviations out.
class SensorModel {
 public:
  /// @param profile its lens' vignetting, exposure and noise count
  /// @param camera names the noise's streams; two cameras of one name have the same noise
  /// @throws hardware::ConfigError
  SensorModel(const CameraProfile& profile, const hardware::CameraModel& model, std::uint64_t seed,
              std::string_view camera);

  /// Whether Apply() changes nothing in full light.
  bool ideal() const { return !has_gain_ && read_noise_ == 0 && shot_gain_ == 0 && levels_ == 255; }

  /// @param bgr CV_8UC3 of the model's size, changed in place; rounded and clamped to 0..255
  /// @param light share of it that reaches the sensor; the noise of the sensor stays
  void Apply(std::uint64_t frame, cv::Mat& bgr, double light = 1) const;

 private:
  void Expose(int y, const std::uint8_t* row, float light, float* signal) const;
  void AddNoise(std::uint64_t frame, int y, float* signal, float* normal, float* sigma) const;
  void Digitise(float* signal, std::uint8_t* row) const;

  int width_;
  int height_;
  float gain_;
  float read_noise_;
  float shot_gain_;
  float levels_;  ///< highest number of the converter
  bool has_gain_;
  std::array<std::uint8_t, 256> grey_;  ///< that a number of the converter stands for
  std::vector<float> column_loss_;      ///< by which vignetting lowers the gain, per value of a row
  std::vector<float> row_loss_;         ///< likewise, per row
  std::uint64_t read_stream_;
  std::uint64_t shot_stream_;
};

}  // namespace horopter::sim
