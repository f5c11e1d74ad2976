// SPDX-License-Identifier: Apache-2.0
#include "scenarios/format/metric_registry.h"

#include <algorithm>
#include <cmath>

namespace horopter::scenarios {
namespace {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();

std::string StatisticDoc(const std::string& statistic) {
  if (statistic == "p95") return "95th percentile";
  if (statistic == "max") return "largest";
  return statistic;
}

/// One metric per statistic: `<family>.mean`, `<family>.p95`. `of` has the family's name and the
/// sentence that follows "mean ".
void AddFamily(std::vector<Metric>& metrics, const Metric& of,
               const std::vector<std::string>& statistics) {
  for (const std::string& statistic : statistics) {
    Metric metric = of;
    metric.name += "." + statistic;
    metric.doc = StatisticDoc(statistic) + " " + of.doc;
    metrics.push_back(std::move(metric));
  }
}

std::vector<Metric> MakeMetrics() {
  std::vector<Metric> m;
  m.push_back({.name = "reached",
               .unit = "m",
               .doc = "true distance of the base from its goal at the end of a goto step, the "
                      "largest over the steps that were begun",
               .needs = MetricNeeds::kGoal});
  m.push_back({.name = "time_to_goal",
               .unit = "s",
               .doc = "simulated time that the goto steps took together; nothing unless every one "
                      "arrived, by the robot's own account",
               .needs_truth = false,
               .needs = MetricNeeds::kGoal});
  m.push_back({.name = "contacts",
               .unit = "",
               .doc = "times the robot began to touch anything but the floor",
               .whole = true});
  m.push_back({.name = "clearance",
               .unit = "m",
               .doc = "smallest distance between robot and obstacles on the driven path",
               .better = Better::kHigher});
  m.push_back({.name = "path_length", .unit = "m", .doc = "length of the driven path"});
  m.push_back({.name = "odometry.error",
               .unit = "m",
               .doc = "distance between the pose by odometry and the true one at the end"});
  AddFamily(m,
            {.name = "depth.abs_rel",
             .unit = "",
             .doc = "absolute relative depth error over valid pixels"},
            {"median", "mean", "p95"});
  m.push_back({.name = "depth.density",
               .unit = "",
               .doc = "share of pixels with a depth",
               .needs_truth = false,
               .better = Better::kHigher,
               .max = 1});
  m.push_back({.name = "depth.bias",
               .unit = "m",
               .doc = "mean signed depth error over valid pixels, positive when too far",
               .better = Better::kNearZero,
               .min = -kUnbounded});
  m.push_back({.name = "board.depth_error.mean",
               .unit = "m",
               .doc = "magnitude of the mean signed depth error over the board's squares",
               .needs = MetricNeeds::kBoard});
  m.push_back({.name = "board.depth_error.std",
               .unit = "m",
               .doc = "standard deviation of the depth error over the board's squares",
               .needs = MetricNeeds::kBoard});
  m.push_back({.name = "board.density",
               .unit = "",
               .doc = "share of the pixels on the board's squares that have a depth",
               .better = Better::kHigher,
               .needs = MetricNeeds::kBoard,
               .max = 1});
  AddFamily(m,
            {.name = "fixation.error_deg",
             .unit = "deg",
             .doc = "angle between an eye's optical axis and the true direction of its target",
             .needs = MetricNeeds::kFixation},
            {"mean", "median", "p95", "max"});
  return m;
}

}  // namespace

const std::vector<Metric>& Metrics() {
  static const std::vector<Metric> metrics = MakeMetrics();
  return metrics;
}

const Metric* FindMetric(std::string_view name) {
  const auto& all = Metrics();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Metric& m) { return m.name == name; });
  return found == all.end() ? nullptr : &*found;
}

std::vector<std::string> MetricNames() {
  std::vector<std::string> names;
  for (const Metric& metric : Metrics()) names.push_back(metric.name);
  return names;
}

const std::vector<Unit>& Units() {
  static const std::vector<Unit> units = {{"m", "m", 1},
                                          {"cm", "m", 0.01},
                                          {"mm", "m", 0.001},
                                          {"deg", "deg", 1},
                                          {"rad", "deg", 180 / M_PI},
                                          {"s", "s", 1},
                                          {"ms", "s", 0.001},
                                          {"%", "", 0.01}};
  return units;
}

std::vector<std::string> UnitNamesFor(const Metric& metric) {
  std::vector<std::string> names;
  if (metric.whole) return names;
  for (const Unit& unit : Units()) {
    if (unit.base == metric.unit) names.push_back(unit.name);
  }
  return names;
}

std::optional<double> ToMetricUnit(double value, std::string_view unit, const Metric& metric) {
  if (unit.empty()) return value;
  for (const Unit& u : Units()) {
    if (u.name == unit && u.base == metric.unit && !metric.whole) return value * u.scale;
  }
  return std::nullopt;
}

}  // namespace horopter::scenarios
