// SPDX-License-Identifier: Apache-2.0
#include "sim/camera/camera_profile.h"

#include <fmt/format.h>

#include "hardware/types/field_checker.h"

namespace horopter::sim {
namespace {

constexpr double kReferenceWidth = 640;

CameraProfile WebcamVga() {
  CameraProfile p;
  p.name = "webcam_vga";
  p.lens = {.distortion = {.k1 = -0.12, .k2 = 0.05, .p1 = 0.0005, .p2 = -0.0004},
            .principal_point_offset_px = {4.3, -3.1},
            .blur_px = 0.5,
            .vignetting = 0.15};
  p.exposure.time_s = 0.010;
  p.noise = {.read_noise_dn = 1.5, .shot_gain_dn = 0.053};
  p.shutter = {Shutter::kRolling, 0.030};
  p.timing = {.rate_hz = 30, .latency_s = 0.040, .delivery_jitter_s = 0.004};
  return p;
}

CameraProfile VgaNoise() {
  CameraProfile p;
  p.name = "vga_noise";
  p.noise = WebcamVga().noise;
  return p;
}

CameraProfile LifecamVx6000() {
  CameraProfile p = WebcamVga();
  p.name = "lifecam_vx6000";
  p.lens = {.distortion = {.k1 = -0.21, .k2 = 0.09, .p1 = 0.0008, .p2 = 0.0006, .k3 = -0.02},
            .principal_point_offset_px = {-6.2, 5.4},
            .blur_px = 0.6,
            .vignetting = 0.25};
  return p;
}

CameraProfile SonyXc999() {
  CameraProfile p;
  p.name = "sony_xc999";
  p.lens = {.distortion = {.k1 = -0.05, .k2 = 0.01},
            .principal_point_offset_px = {-3.5, 2.0},
            .pixel_aspect = 1.0,
            .blur_px = 0.7,
            .vignetting = 0.08};
  p.exposure.time_s = 0.020;
  p.noise = {.read_noise_dn = 1.0, .shot_gain_dn = 0.004};
  p.shutter = {Shutter::kInterlaced, 0.020};
  p.timing = {.rate_hz = 25, .latency_s = 0.003};
  return p;
}

}  // namespace

hardware::CameraModel LensProfile::Model(int width, int height, double horizontal_fov_rad) const {
  hardware::Intrinsics in =
      hardware::CameraModel::FromHorizontalFov(width, height, horizontal_fov_rad).intrinsics();
  in.fy = in.fx * pixel_aspect;
  in.cx += principal_point_offset_px.x() * width / kReferenceWidth;
  in.cy += principal_point_offset_px.y() * width / kReferenceWidth;
  return hardware::CameraModel(in, distortion);
}

std::vector<hardware::FieldError> CameraProfile::Validate() const {
  hardware::FieldChecker checks("camera.");
  const auto between = [&checks](const char* field, double value, double low, double high,
                                 const char* rule) {
    checks.Require(value >= low && value <= high, field, value, rule);
  };
  between("lens.pixel_aspect", lens.pixel_aspect, 0.2, 5, "must be from 0.2 to 5");
  between("lens.blur_px", lens.blur_px, 0, 10, "must be from 0 to 10");
  between("lens.vignetting", lens.vignetting, 0, 1, "must be from 0 to 1");
  between("exposure.time_s", exposure.time_s, 0, 0.2, "must be from 0 to 0.2");
  between("exposure.gain", exposure.gain, 0.01, 100, "must be from 0.01 to 100");
  between("noise.read_noise_dn", noise.read_noise_dn, 0, 255, "must be from 0 to 255");
  between("noise.shot_gain_dn", noise.shot_gain_dn, 0, 255, "must be from 0 to 255");
  between("noise.bits", noise.bits, 1, 8, "must be from 1 to 8");
  between("shutter.readout_s", shutter.readout_s, 0, 0.2, "must be from 0 to 0.2");
  between("timing.rate_hz", timing.rate_hz, 0, 1000, "must be from 0 to 1000");
  between("timing.latency_s", timing.latency_s, 0, 2, "must be from 0 to 2");
  between("timing.drop_probability", timing.drop_probability, 0, 0.9, "must be from 0 to 0.9");
  between("timing.repeat_probability", timing.repeat_probability, 0, 0.9, "must be from 0 to 0.9");
  const double period_s = timing.rate_hz > 0 ? 1 / timing.rate_hz : 0;
  between("timing.capture_jitter_s", timing.capture_jitter_s, 0, period_s / 4,
          "must be from 0 to a quarter of the frame period");
  between("timing.delivery_jitter_s", timing.delivery_jitter_s, 0, period_s / 2,
          "must be from 0 to half the frame period");
  between("timing.skew_s", timing.skew_s, -0.1, 0.1, "must be from -0.1 to 0.1");
  checks.Require(
      timing.rate_hz > 0 || (timing.drop_probability == 0 && timing.repeat_probability == 0),
      "timing.rate_hz", timing.rate_hz, "must be positive for frames to be dropped or repeated");
  return checks.Take();
}

std::vector<std::string> CameraProfile::Names() {
  return {"ideal", "vga_noise", "webcam_vga", "lifecam_vx6000", "sony_xc999"};
}

CameraProfile CameraProfile::Named(std::string_view name) {
  if (name == "ideal") return {};
  if (name == "vga_noise") return VgaNoise();
  if (name == "webcam_vga") return WebcamVga();
  if (name == "lifecam_vx6000") return LifecamVx6000();
  if (name == "sony_xc999") return SonyXc999();
  throw hardware::ConfigError({{"camera profile", std::string(name),
                                fmt::format("must be one of: {}", fmt::join(Names(), ", "))}});
}

}  // namespace horopter::sim
