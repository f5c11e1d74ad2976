// SPDX-License-Identifier: Apache-2.0
#include "sim/camera/sensor_model.h"

#include <algorithm>
#include <opencv2/core.hpp>
#include <string>

#include "sim/random/random_stream.h"

namespace horopter::sim {
namespace {

/// Of the noise that follows from the stream, the frame and the row alone.
std::uint64_t KeyOf(std::uint64_t stream, std::uint64_t frame, int y) {
  constexpr std::uint64_t kRowStride = 0x9e3779b97f4a7c15ULL;
  return MixBits(MixBits(stream ^ MixBits(frame)) + static_cast<std::uint64_t>(y) * kRowStride);
}

std::uint64_t Stream(std::uint64_t seed, const char* what, std::string_view camera) {
  return RandomStream(seed, std::string("camera.") + what + "." + std::string(camera)).Next();
}

}  // namespace

SensorModel::SensorModel(const CameraProfile& profile, const hardware::CameraModel& model,
                         std::uint64_t seed, std::string_view camera, const RowKernels& kernels)
    : kernels_(&kernels),
      width_(model.width()),
      height_(model.height()),
      gain_(static_cast<float>(profile.exposure.gain)),
      read_noise_(static_cast<float>(profile.noise.read_noise_dn)),
      shot_gain_(static_cast<float>(profile.noise.shot_gain_dn)),
      levels_(static_cast<float>((1 << std::clamp(profile.noise.bits, 1, 8)) - 1)),
      has_gain_(profile.exposure.gain != 1 || profile.lens.vignetting != 0),
      read_stream_(Stream(seed, "read_noise", camera)),
      shot_stream_(Stream(seed, "shot_noise", camera)) {
  hardware::ThrowIfAny(profile.Validate());
  for (int level = 0; level < 256; ++level) {
    grey_[level] = cv::saturate_cast<std::uint8_t>(level * 255 / levels_);
  }
  // The loss is separable: proportional to dx^2 + dy^2, and all of it at the farthest corner.
  const hardware::Intrinsics& in = model.intrinsics();
  const auto square = [](double pixels, double focal) { return pixels / focal * pixels / focal; };
  const double corner = square(std::max(in.cx, in.width - 1 - in.cx), in.fx) +
                        square(std::max(in.cy, in.height - 1 - in.cy), in.fy);
  const double loss = corner > 0 ? profile.exposure.gain * profile.lens.vignetting / corner : 0;
  for (int x = 0; x < in.width; ++x) {
    column_loss_.insert(column_loss_.end(), 3, static_cast<float>(loss * square(x - in.cx, in.fx)));
  }
  column_loss_.resize((column_loss_.size() + kRowWidthStep - 1) / kRowWidthStep * kRowWidthStep);
  for (int y = 0; y < in.height; ++y) {
    row_loss_.push_back(static_cast<float>(loss * square(y - in.cy, in.fy)));
  }
}

void SensorModel::ApplyToRow(std::uint64_t frame, int y, float light, std::uint8_t* row) const {
  const int values = 3 * width_;
  kernels_->expose({.loss = column_loss_.data(),
                    .gain = gain_ - row_loss_[y],
                    .light = light,
                    .shot_gain = shot_gain_,
                    .read_noise = read_noise_,
                    .digits_per_level = levels_ / 255,
                    .shot_key = KeyOf(shot_stream_, frame, y),
                    .read_key = KeyOf(read_stream_, frame, y)},
                   values, row);
  if (levels_ < 255) {
    for (int i = 0; i < values; ++i) row[i] = grey_[row[i]];
  }
}

void SensorModel::Apply(std::uint64_t frame, cv::Mat& bgr, double light) const {
  CV_Assert(bgr.type() == CV_8UC3 && bgr.cols == width_ && bgr.rows == height_);
  if (ideal() && light == 1) return;
  cv::parallel_for_(cv::Range(0, bgr.rows), [&](const cv::Range& rows) {
    for (int y = rows.start; y < rows.end; ++y) {
      ApplyToRow(frame, y, static_cast<float>(light), bgr.ptr<std::uint8_t>(y));
    }
  });
}

}  // namespace horopter::sim
