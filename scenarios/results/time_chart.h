// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace horopter::scenarios {

/// One line of a chart over time. Where a value is missing the line has a gap.
struct TimeSeries {
  std::string name;
  std::vector<std::pair<double, std::optional<double>>> points;  ///< (t [s], value)
};

/// A limit drawn across a chart.
struct ChartLimit {
  std::string name;
  double value = 0;
};

/// A chart of one quantity over time, zero at the bottom unless values are negative.
struct TimeChart {
  std::string title;
  std::string unit;
  std::vector<TimeSeries> series;  ///< at most two
  std::vector<ChartLimit> limits;
  std::vector<std::pair<double, std::string>> steps;  ///< (start [s], name) of the run's steps
};

/// The chart as an SVG element whose colours come from the page's CSS variables (report_style.h).
/// @return nothing when no series has a value
std::optional<std::string> TimeChartSvg(const TimeChart& chart, double end_s);

}  // namespace horopter::scenarios
