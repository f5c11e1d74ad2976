// SPDX-License-Identifier: Apache-2.0
#include "sim/camera/sensor_model.h"

#include <array>
#include <cmath>
#include <opencv2/core.hpp>

#include "sim/random/random_stream.h"

namespace horopter::sim {
namespace {

constexpr int kQuantiles = 1 << 16;

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

/// Standard normal numbers at equal probabilities: 16 random bits choose one.
const std::array<float, kQuantiles>& NormalTable() {
  static const auto table = [] {
    std::array<float, kQuantiles> t;
    for (int i = 0; i < kQuantiles / 2; ++i) {
      t[i] = static_cast<float>(NormalQuantile((i + 0.5) / kQuantiles));
      t[kQuantiles - 1 - i] = -t[i];
    }
    return t;
  }();
  return table;
}

}  // namespace

std::vector<hardware::FieldError> SensorProfile::Validate() const {
  std::vector<hardware::FieldError> errors;
  const auto require = [&errors](const char* field, double value) {
    if (!(value >= 0 && value < 256)) {
      errors.push_back({field, std::to_string(value), "must be at least 0 and below 256"});
    }
  };
  require("sensor.read_noise_dn", read_noise_dn);
  require("sensor.shot_gain_dn", shot_gain_dn);
  return errors;
}

std::vector<std::string> SensorProfile::Names() { return {"ideal", "webcam_vga"}; }

SensorProfile SensorProfile::Named(std::string_view name) {
  if (name == "ideal") return {};
  if (name == "webcam_vga") return {"webcam_vga", 1.5, 0.053};
  throw hardware::ConfigError(
      {{"camera.sensor", std::string(name), "must be one of: ideal, webcam_vga"}});
}

SensorModel::SensorModel(const SensorProfile& profile, std::uint64_t seed, hardware::Eye eye)
    : profile_(profile),
      stream_(RandomStream(seed, std::string("camera.noise.") + ToString(eye)).Next()),
      sigma_(256) {
  hardware::ThrowIfAny(profile.Validate());
  for (int s = 0; s < 256; ++s) {
    sigma_[s] = static_cast<float>(
        std::sqrt(profile.read_noise_dn * profile.read_noise_dn + profile.shot_gain_dn * s));
  }
}

void SensorModel::Apply(std::uint64_t frame, cv::Mat& bgr) const {
  CV_Assert(bgr.type() == CV_8UC3);
  if (profile_.read_noise_dn == 0 && profile_.shot_gain_dn == 0) return;
  const auto& normal = NormalTable();
  const std::uint64_t frame_stream = MixBits(stream_ ^ MixBits(frame));
  const int values = bgr.cols * 3;
  cv::parallel_for_(cv::Range(0, bgr.rows), [&](const cv::Range& rows) {
    for (int y = rows.start; y < rows.end; ++y) {
      std::uint8_t* row = bgr.ptr<std::uint8_t>(y);
      std::uint64_t counter = frame_stream + static_cast<std::uint64_t>(y) * 0x9e3779b97f4a7c15ULL;
      for (int x = 0; x < values;) {
        std::uint64_t bits = MixBits(counter++);
        for (int k = 0; k < 4 && x < values; ++k, ++x, bits >>= 16) {
          row[x] = cv::saturate_cast<std::uint8_t>(row[x] + sigma_[row[x]] * normal[bits & 0xffff]);
        }
      }
    }
  });
}

}  // namespace horopter::sim
