// SPDX-License-Identifier: Apache-2.0
#include "sim/camera/sensor_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/core/hal/hal.hpp>
#include <string>

#include "sim/random/random_stream.h"

namespace horopter::sim {
namespace {

constexpr int kQuantileBits = 12;
constexpr int kQuantiles = 1 << kQuantileBits;
constexpr int kDrawsPerWord = 64 / kQuantileBits;

/// x with Phi(x) = p, by Newton's method from the logistic approximation of the normal law.
double NormalQuantile(double p) {
  double x = std::log(p / (1 - p)) / 1.702;
  for (int i = 0; i < 40; ++i) {
    const double error = 0.5 * std::erfc(-x / M_SQRT2) - p;
    const double density = std::exp(-0.5 * x * x) / std::sqrt(2 * M_PI);
    const double step = std::clamp(error / density, -0.5, 0.5);
    x -= step;
    if (std::abs(step) < 1e-13) break;
  }
  return x;
}

/// Normal numbers at equal probabilities, scaled to a variance of exactly 1: random bits choose
/// one. Small enough for the first-level cache.
const std::array<float, kQuantiles>& NormalTable() {
  static const auto table = [] {
    std::array<double, kQuantiles / 2> half;
    double square_sum = 0;
    for (int i = 0; i < kQuantiles / 2; ++i) {
      half[i] = NormalQuantile((i + 0.5) / kQuantiles);
      square_sum += half[i] * half[i];
    }
    const double scale = 1 / std::sqrt(square_sum / (kQuantiles / 2));
    std::array<float, kQuantiles> t;
    for (int i = 0; i < kQuantiles / 2; ++i) {
      t[i] = static_cast<float>(scale * half[i]);
      t[kQuantiles - 1 - i] = -t[i];
    }
    return t;
  }();
  return table;
}

/// Fills a row with normal numbers that follow from the stream, the frame and the row alone.
void DrawNormals(std::uint64_t stream, std::uint64_t frame, int y, int count, float* normal) {
  constexpr std::uint64_t kRowStride = 0x9e3779b97f4a7c15ULL;
  const auto& table = NormalTable();
  std::uint64_t counter =
      MixBits(stream ^ MixBits(frame)) + static_cast<std::uint64_t>(y) * kRowStride;
  int i = 0;
  for (; i + kDrawsPerWord <= count; i += kDrawsPerWord) {
    std::uint64_t bits = MixBits(counter++);
    for (int k = 0; k < kDrawsPerWord; ++k, bits >>= kQuantileBits) {
      normal[i + k] = table[bits & (kQuantiles - 1)];
    }
  }
  for (std::uint64_t bits = MixBits(counter); i < count; ++i, bits >>= kQuantileBits) {
    normal[i] = table[bits & (kQuantiles - 1)];
  }
}

std::uint64_t Stream(std::uint64_t seed, const char* what, std::string_view camera) {
  return RandomStream(seed, std::string("camera.") + what + "." + std::string(camera)).Next();
}

}  // namespace

SensorModel::SensorModel(const CameraProfile& profile, const hardware::CameraModel& model,
                         std::uint64_t seed, std::string_view camera)
    : width_(model.width()),
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
  for (int y = 0; y < in.height; ++y) {
    row_loss_.push_back(static_cast<float>(loss * square(y - in.cy, in.fy)));
  }
}

void SensorModel::Expose(int y, const std::uint8_t* row, float light, float* signal) const {
  const float gain = gain_ - row_loss_[y];
  const float* loss = column_loss_.data();
  for (int i = 0; i < 3 * width_; ++i) signal[i] = row[i] * (gain - loss[i]);
  if (light == 1) return;
  for (int i = 0; i < 3 * width_; ++i) signal[i] *= light;
}

void SensorModel::AddNoise(std::uint64_t frame, int y, float* signal, float* normal,
                           float* sigma) const {
  const int values = 3 * width_;
  // Shot noise first: it follows the light alone.
  if (shot_gain_ > 0) {
    DrawNormals(shot_stream_, frame, y, values, normal);
    for (int i = 0; i < values; ++i) sigma[i] = shot_gain_ * signal[i];
    cv::hal::sqrt32f(sigma, sigma, values);
    for (int i = 0; i < values; ++i) signal[i] += sigma[i] * normal[i];
  }
  if (read_noise_ > 0) {
    DrawNormals(read_stream_, frame, y, values, normal);
    for (int i = 0; i < values; ++i) signal[i] += read_noise_ * normal[i];
  }
}

void SensorModel::Digitise(float* signal, std::uint8_t* row) const {
  cv::Mat1b digits(1, 3 * width_, row);
  cv::Mat1f(1, 3 * width_, signal).convertTo(digits, CV_8U, levels_ / 255);  // rounds and clips
  if (levels_ < 255) {
    for (int i = 0; i < 3 * width_; ++i) row[i] = grey_[row[i]];
  }
}

void SensorModel::Apply(std::uint64_t frame, cv::Mat& bgr, double light) const {
  CV_Assert(bgr.type() == CV_8UC3 && bgr.cols == width_ && bgr.rows == height_);
  if (ideal() && light == 1) return;
  cv::parallel_for_(cv::Range(0, bgr.rows), [&](const cv::Range& rows) {
    thread_local std::vector<float> signal, normal, sigma;  // kept from frame to frame
    for (std::vector<float>* values : {&signal, &normal, &sigma}) {
      values->resize(3 * static_cast<std::size_t>(width_));
    }
    for (int y = rows.start; y < rows.end; ++y) {
      std::uint8_t* row = bgr.ptr<std::uint8_t>(y);
      Expose(y, row, static_cast<float>(light), signal.data());
      AddNoise(frame, y, signal.data(), normal.data(), sigma.data());
      Digitise(signal.data(), row);
    }
  });
}

}  // namespace horopter::sim
