// SPDX-License-Identifier: Apache-2.0
#include "scenarios/render/gaze_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "hardware/types/config_error.h"
#include "sim/random/random_stream.h"

namespace horopter::scenarios {
namespace {

using hardware::HeadAxis;

constexpr double kRadians = M_PI / 180;
constexpr int kMostDraws = 1000;

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

[[noreturn]] void RefuseTilts(const GazeBounds& bounds) {
  throw hardware::ConfigError(
      {{"--tilt", fmt::format("{:g}:{:g}", bounds.tilt_deg.low, bounds.tilt_deg.high),
        fmt::format("is out of the head's reach at pans of {:g}:{:g} deg", bounds.pan_deg.low,
                    bounds.pan_deg.high)}});
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

std::vector<Gaze> SampleGazes(const GazeBounds& bounds, int count, std::uint64_t seed,
                              const HeadReach& reach) {
  sim::RandomStream pan(seed, "render.pan");
  sim::RandomStream tilt(seed, "render.tilt");
  sim::RandomStream vergence(seed, "render.vergence");
  const auto draw = [](sim::RandomStream& random, const Interval& interval) {
    return random.Uniform(interval.low, interval.high);
  };
  const bool by_neck = Of(reach.limits(), HeadAxis::kNeckTilt).exists();
  const GazeBounds within = bounds.Within(reach.limits());
  const auto tilts_at = [&](double pan_deg) {
    if (!by_neck) return within.tilt_deg;
    const Interval range = reach.NeckTiltAt(pan_deg);
    return Interval{std::max(within.tilt_deg.low, range.low),
                    std::min(within.tilt_deg.high, range.high)};
  };
  std::vector<Gaze> gazes;
  for (int i = 0; i < count; ++i) {
    double pan_deg = draw(pan, within.pan_deg);
    Interval tilts = tilts_at(pan_deg);
    for (int redrawn = 0; tilts.low > tilts.high; ++redrawn) {
      if (redrawn == kMostDraws) RefuseTilts(within);
      pan_deg = draw(pan, within.pan_deg);
      tilts = tilts_at(pan_deg);
    }
    gazes.push_back({pan_deg, draw(tilt, tilts), draw(vergence, within.vergence_deg)});
  }
  return gazes;
}

}  // namespace horopter::scenarios
