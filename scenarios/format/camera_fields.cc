// SPDX-License-Identifier: Apache-2.0
#include "scenarios/format/camera_fields.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "scenarios/format/field_parser.h"
#include "scenarios/format/read_text.h"

namespace horopter::scenarios {
namespace {

void Visit(FieldVisitor& v, sim::LensProfile& s) {
  std::array<double, 5> d{s.distortion.k1, s.distortion.k2, s.distortion.p1, s.distortion.p2,
                          s.distortion.k3};
  v.Numbers({"distortion", "", "Brown-Conrady: k1, k2, p1, p2, k3 (OpenCV's order)."}, {-5, 5}, d);
  s.distortion = {d[0], d[1], d[2], d[3], d[4]};
  v.Numbers({"principal_point_offset_px", "px",
             "Where the optical axis meets the sensor, right and down of its middle, at a width of "
             "640."},
            {-200, 200}, {s.principal_point_offset_px.data(), 2});
  v.Number({"pixel_aspect", "", "Vertical over horizontal focal length in pixels."}, {0.2, 5},
           s.pixel_aspect);
  v.Number({"blur_px", "px", "Standard deviation of the point spread."}, {0, 10}, s.blur_px);
  v.Number({"vignetting", "", "Share of light lost in the corners."}, {0, 1}, s.vignetting);
}

void Visit(FieldVisitor& v, sim::ExposureProfile& s) {
  v.Number({"time_s", "s", "How long light is gathered; motion blurs what moves meanwhile."},
           {0, 0.2}, s.time_s);
  v.Number({"gain", "", "Grey levels are multiplied by it."}, {0.01, 100}, s.gain);
}

void Visit(FieldVisitor& v, sim::NoiseProfile& s) {
  v.Number({"read_noise_dn", "DN", "Standard deviation in the dark."}, {0, 255}, s.read_noise_dn);
  v.Number({"shot_gain_dn", "DN", "Variance added per grey level of signal."}, {0, 255},
           s.shot_gain_dn);
  v.Integral({"bits", "", "Of the converter."}, {1, 8}, s.bits);
}

void Visit(FieldVisitor& v, sim::ShutterProfile& s) {
  const std::vector<std::string> names = {"global", "rolling", "interlaced"};
  std::string kind = names.at(static_cast<std::size_t>(s.kind));
  v.Choice({"kind", "", "Which rows are exposed when."}, names, kind);
  s.kind = static_cast<sim::Shutter>(std::find(names.begin(), names.end(), kind) - names.begin());
  v.Number({"readout_s", "s", "From the first row, or field, to the last."}, {0, 0.2}, s.readout_s);
}

void Visit(FieldVisitor& v, sim::TimingProfile& s) {
  v.Number({"rate_hz", "Hz", "Frames per second; 0 = one whenever the stack asks."}, {0, 1000},
           s.rate_hz);
  v.Number({"latency_s", "s", "From the end of the exposure to delivery."}, {0, 2}, s.latency_s);
  v.Number({"capture_jitter_s", "s", "Captures are early or late by up to this."}, {0, 1},
           s.capture_jitter_s);
  v.Number({"delivery_jitter_s", "s", "Deliveries are late by up to this."}, {0, 1},
           s.delivery_jitter_s);
  v.Number({"drop_probability", "", "Of a frame that never comes."}, {0, 0.9}, s.drop_probability);
  v.Number({"repeat_probability", "", "Of a frame that shows the one before it."}, {0, 0.9},
           s.repeat_probability);
  v.Number({"skew_s", "s", "By how much the right eye captures later than the left."}, {-0.1, 0.1},
           s.skew_s);
}

/// The name first: it sets what the sections may then change by hand.
void VisitProfile(FieldVisitor& v, sim::CameraProfile& s) {
  std::string name = s.name;
  v.Choice({"profile", "", "What lens, sensor and timing do to a perfect image."},
           sim::CameraProfile::Names(), name);
  if (name != s.name) s = sim::CameraProfile::Named(name);
  v.Section({"lens", "", "In place of the profile's."},
            [&s](FieldVisitor& w) { Visit(w, s.lens); });
  v.Section({"exposure", "", "In place of the profile's."},
            [&s](FieldVisitor& w) { Visit(w, s.exposure); });
  v.Section({"noise", "", "In place of the profile's."},
            [&s](FieldVisitor& w) { Visit(w, s.noise); });
  v.Section({"shutter", "", "In place of the profile's."},
            [&s](FieldVisitor& w) { Visit(w, s.shutter); });
  v.Section({"timing", "", "In place of the profile's."},
            [&s](FieldVisitor& w) { Visit(w, s.timing); });
}

}  // namespace

void Visit(FieldVisitor& v, CameraSpec& s) {
  v.Integral({"width", "px", "Columns of each eye's image."}, {16, 4096}, s.width);
  v.Integral({"height", "px", "Rows of each eye's image."}, {16, 4096}, s.height);
  v.Number(
      {"horizontal_fov_deg", "deg", "Horizontal field of view of each eye; left out: the robot's."},
      {5, 150}, s.horizontal_fov_deg);
  VisitProfile(v, s.profile);
}

CameraSpec ReadCameraFile(const std::filesystem::path& path, CameraSpec defaults) {
  const YamlNode root = ParseYaml(ReadText(path), path.string());
  ParseReport report;
  ParseFields(
      root, [&defaults](FieldVisitor& v) { Visit(v, defaults); }, report);
  for (const hardware::FieldError& error : defaults.profile.Validate()) {
    const auto found = report.marks.find(error.field.substr(std::string("camera.").size()));
    report.Add(found == report.marks.end() ? root.mark : found->second, error.ToString());
  }
  ThrowIfAny(std::move(report.diagnostics));
  return defaults;
}

}  // namespace horopter::scenarios
