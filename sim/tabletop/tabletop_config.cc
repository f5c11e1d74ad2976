// SPDX-License-Identifier: Apache-2.0
#include "sim/tabletop/tabletop_config.h"

#include <fmt/core.h>

#include "sim/tabletop/light_colour.h"

namespace horopter::sim {

namespace {

/// Collects the fields that are not in their range.
class Checks {
 public:
  void Within(const char* field, double value, double low, double high) {
    if (std::isfinite(value) && value >= low && value <= high) return;
    errors_.push_back({std::string("tabletop.") + field, fmt::format("{}", value),
                       fmt::format("must be from {:.6g} to {:.6g}", low, high)});
  }
  void Require(bool good, const char* field, const std::string& value, const char* constraint) {
    if (!good) errors_.push_back({std::string("tabletop.") + field, value, constraint});
  }
  std::vector<hardware::FieldError> Take() { return std::move(errors_); }

 private:
  std::vector<hardware::FieldError> errors_;
};

void CheckLight(const LightConfig& light, Checks& checks) {
  constexpr double kLow_k = kLowestColourTemperature_k, kHigh_k = kHighestColourTemperature_k;
  const double up = light.elevation_rad, up_spread = light.elevation_spread_rad;
  checks.Within("light.azimuth_rad", light.azimuth_rad, -2 * M_PI, 2 * M_PI);
  checks.Within("light.azimuth_spread_rad", light.azimuth_spread_rad, 0, M_PI);
  // A lower lamp would shine through the walls, a shadow without end.
  constexpr double kLowest = 20 * M_PI / 180;
  checks.Within("light.elevation_rad", up, kLowest, M_PI / 2);
  checks.Within("light.elevation_spread_rad", up_spread, 0, std::max(0.0, up - kLowest));
  checks.Within("light.brightness", light.brightness, 0.05, 2);
  checks.Within("light.brightness_spread", light.brightness_spread, 0, light.brightness);
  checks.Within("light.colour_temperature_k", light.colour_temperature_k, kLow_k, kHigh_k);
  checks.Within("light.colour_temperature_spread_k", light.colour_temperature_spread_k, 0,
                std::max(0.0, light.colour_temperature_k - kLow_k));
}

}  // namespace

std::vector<hardware::FieldError> TabletopConfig::Validate() const {
  Checks checks;
  checks.Within("arrangement.yaw_spread_rad", arrangement.yaw_spread_rad, 0, M_PI);
  checks.Within("arrangement.depth_m", arrangement.depth_m, 0.1, 10);
  checks.Within("arrangement.width_m", arrangement.width_m, 0.1, 10);
  checks.Within("arrangement.gap_m", arrangement.gap_m, 0.001, 0.2);
  checks.Within("arrangement.max_hidden", arrangement.max_hidden, 0, 1);
  checks.Within("clutter.count", clutter.count, 0, 100);
  checks.Within("clutter.max_hidden", clutter.max_hidden, 0, 1);
  if (occlusion) {
    checks.Within("occlusion.fraction", occlusion->fraction, 0.05, 0.95);
    checks.Require(occlusion->target != occlusion->by, "occlusion.by", occlusion->by,
                   "must be another object than the target");
  }
  CheckLight(light, checks);
  if (viewpoint_W) {
    checks.Require(viewpoint_W->allFinite(), "viewpoint_W", "not finite", "must be finite");
  }
  return checks.Take();
}

}  // namespace horopter::sim
