// SPDX-License-Identifier: Apache-2.0
#include "scenarios/render/gaze_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "control/kinematics/gaze_angles.h"
#include "hardware/types/config_error.h"
#include "scenarios/dataset/csv.h"
#include "scenarios/dataset/format_error.h"
#include "sim/random/random_stream.h"

namespace horopter::scenarios {
namespace {

using hardware::HeadAxis;

constexpr double kRadians = M_PI / 180;

const hardware::AxisLimits& Of(const hardware::HeadLimits& limits, HeadAxis axis) {
  return limits[static_cast<std::size_t>(axis)];
}

Interval Degrees(const hardware::AxisLimits& axis) {
  return {axis.min_rad / kRadians, axis.max_rad / kRadians};
}

Interval Common(const Interval& a, const Interval& b) {
  const double low = std::max(a.low, b.low);
  return {low, std::max(low, std::min(a.high, b.high))};
}

}  // namespace

GazeBounds GazeBounds::Within(const hardware::HeadLimits& limits) const {
  const bool neck = Of(limits, HeadAxis::kNeckPan).exists();
  GazeBounds within = *this;
  within.pan_deg =
      Common(pan_deg, Degrees(Of(limits, neck ? HeadAxis::kNeckPan : HeadAxis::kLeftPan)));
  within.tilt_deg =
      Common(tilt_deg, Degrees(Of(limits, neck ? HeadAxis::kNeckTilt : HeadAxis::kLeftTilt)));
  // Half the vergence comes on top of the version on eyes that do both.
  const double aside = neck ? 0 : std::max(std::abs(within.pan_deg.low), within.pan_deg.high);
  const double turn = 2 * std::max(0.0, -Of(limits, HeadAxis::kLeftPan).min_rad / kRadians - aside);
  within.vergence_deg = Common(vergence_deg, {0, turn});
  return within;
}

Interval ParseInterval(const std::string& option, const std::string& text) {
  Interval interval;
  std::istringstream in(text);
  char colon = ':';
  if (in >> interval.low) {
    if (in.eof()) return {interval.low, interval.low};
    if (in >> colon >> interval.high && colon == ':' && in.eof() && interval.low <= interval.high) {
      return interval;
    }
  }
  throw hardware::ConfigError({{option, text, "must be a number, or two as LOW:HIGH"}});
}

std::vector<Gaze> DecodeGazes(std::string_view text, const std::string& name) {
  const CsvTable table(text, "pan_deg,tilt_deg,vergence_deg", name);
  if (table.rows() == 0) throw FormatError(name + ": no gaze in it; add a row below the header");
  std::vector<Gaze> gazes;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    gazes.push_back({table.Number(row, 0), table.Number(row, 1), table.Number(row, 2)});
  }
  return gazes;
}

std::vector<Gaze> SampleGazes(const GazeBounds& bounds, int count, std::uint64_t seed) {
  sim::RandomStream pan(seed, "render.pan");
  sim::RandomStream tilt(seed, "render.tilt");
  sim::RandomStream vergence(seed, "render.vergence");
  const auto draw = [](sim::RandomStream& random, const Interval& interval) {
    return random.Uniform(interval.low, interval.high);
  };
  std::vector<Gaze> gazes;
  for (int i = 0; i < count; ++i) {
    gazes.push_back({draw(pan, bounds.pan_deg), draw(tilt, bounds.tilt_deg),
                     draw(vergence, bounds.vergence_deg)});
  }
  return gazes;
}

hardware::HeadAngles AnglesOf(const Gaze& gaze, const hardware::HeadLimits& limits) {
  const control::Fixation turned = control::Turn(
      {{gaze.pan_deg * kRadians, gaze.tilt_deg * kRadians}, gaze.vergence_deg * kRadians}, limits);
  if (turned.reachable()) return turned.angles;
  throw hardware::ConfigError({{"gaze",
                                fmt::format("pan {:g}, tilt {:g}, vergence {:g} deg", gaze.pan_deg,
                                            gaze.tilt_deg, gaze.vergence_deg),
                                "is beyond this head: " + turned.why}});
}

}  // namespace horopter::scenarios
