// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <string_view>
#include <vector>

#include "hardware/types/camera_model.h"
#include "sim/camera/camera_profile.h"
#include "sim/camera/row_kernels.h"

namespace horopter::sim {

/// What a sensor makes of the light that falls on it: exposure and vignetting, shot and read noise,
/// clipping and quantisation, in this order. Grey levels are taken to be proportional to light.
///
/// Noise is a function of (seed, camera, kind of noise, frame number, pixel, channel), so a frame's
/// noise does not depend on the frames before it, nor one kind on the other. It follows the normal
/// law out to 4.45 standard deviations (row_noise.h); the same bits on every processor.
class SensorModel {
 public:
  /// @param profile its lens' vignetting, exposure and noise count
  /// @param camera names the noise's streams; two cameras of one name have the same noise
  /// @throws hardware::ConfigError
  SensorModel(const CameraProfile& profile, const hardware::CameraModel& model, std::uint64_t seed,
              std::string_view camera, const RowKernels& kernels = FastestRowKernels());

  /// Whether Apply() changes nothing in full light.
  bool ideal() const { return !has_gain_ && read_noise_ == 0 && shot_gain_ == 0 && levels_ == 255; }

  /// @param bgr CV_8UC3 of the model's size, changed in place; rounded and clamped to 0..255
  /// @param light share of it that reaches the sensor; the noise of the sensor stays
  void Apply(std::uint64_t frame, cv::Mat& bgr, double light = 1) const;

 private:
  void ApplyToRow(std::uint64_t frame, int y, float light, std::uint8_t* row) const;

  const RowKernels* kernels_;
  int width_;
  int height_;
  float gain_;
  float read_noise_;
  float shot_gain_;
  float levels_;  ///< highest number of the converter
  bool has_gain_;
  std::array<std::uint8_t, 256> grey_;  ///< that a number of the converter stands for
  std::vector<float>
      column_loss_;  ///< by which vignetting lowers the gain, per value of a row, rounded up
  std::vector<float> row_loss_;  ///< likewise, per row
  std::uint64_t read_stream_;
  std::uint64_t shot_stream_;
};

}  // namespace horopter::sim
