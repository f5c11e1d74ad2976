// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace horopter::scenarios {

/// Which way a metric improves.
enum class Better { kLower, kHigher, kNearZero };

/// What a scenario must contain for a metric to have a value.
enum class MetricNeeds { kNothing, kGoal, kFixation, kBoard };  // kBoard: one to fixate

/// A quantity that a run is scored by.
struct Metric {
  std::string name;         ///< as in expectations and in summary.json, e.g. "depth.abs_rel.median"
  std::string unit;         ///< m, deg, s; "" for counts and ratios
  std::string doc;          ///< one sentence
  bool needs_truth = true;  ///< not applicable where only the robot's own senses are at hand
  Better better = Better::kLower;
  MetricNeeds needs = MetricNeeds::kNothing;
  double min = 0;  ///< smallest value it can have
  double max = std::numeric_limits<double>::infinity();
  bool whole = false;  ///< counts something
};

/// Every metric, families together, in the order of reports.
const std::vector<Metric>& Metrics();

/// The metric of that name, or nullptr.
const Metric* FindMetric(std::string_view name);

std::vector<std::string> MetricNames();

/// A unit that expectations may be written in, and its size in the unit that metrics use.
struct Unit {
  std::string name;
  std::string base;  ///< m, deg, s or "" (a ratio)
  double scale = 1;  ///< value_in_base = value * scale
};

/// m cm mm, deg rad, s ms, %.
const std::vector<Unit>& Units();

/// Units in which a metric with this base unit may be written. Counts have none.
std::vector<std::string> UnitNamesFor(const Metric& metric);

/// `value` in the metric's own unit; nothing when the unit does not fit the metric. An empty unit
/// is the metric's own.
std::optional<double> ToMetricUnit(double value, std::string_view unit, const Metric& metric);

}  // namespace horopter::scenarios
