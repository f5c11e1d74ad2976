// SPDX-License-Identifier: Apache-2.0
#include "scenarios/results/time_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scenarios/results/axis.h"
#include "scenarios/results/text.h"

namespace horopter::scenarios {
namespace {

constexpr double kWidth = 640;
constexpr double kHeight = 176;
constexpr double kLeft = 52;
constexpr double kRight = 14;
constexpr double kTop = 44;
constexpr double kBottom = 34;

/// From seconds and values to the picture.
struct ChartView {
  double end_s;
  double low;
  double high;

  double X(double t_s) const { return kLeft + (kWidth - kLeft - kRight) * t_s / end_s; }
  double Y(double value) const {
    return kHeight - kBottom - (kHeight - kTop - kBottom) * (value - low) / (high - low);
  }
};

bool HasValue(const std::optional<double>& value) { return value && std::isfinite(*value); }

/// The values' range with round ends; nothing when there is no value.
std::optional<ChartView> Fit(const TimeChart& chart, double end_s) {
  double low = 0;
  double high = 0;
  bool any = false;
  for (const TimeSeries& series : chart.series) {
    for (const auto& [t_s, value] : series.points) {
      if (!HasValue(value)) continue;
      any = true;
      low = std::min(low, *value);
      high = std::max(high, *value);
      end_s = std::max(end_s, t_s);
    }
  }
  if (!any) return std::nullopt;
  for (const ChartLimit& limit : chart.limits) {
    low = std::min(low, limit.value);
    high = std::max(high, limit.value);
  }
  if (high - low < 1e-12) high = low + 1;
  const double step = NiceStep(high - low, 4);
  return ChartView{end_s > 0 ? end_s : 1, std::floor(low / step + 1e-9) * step,
                   std::ceil(high / step * (1 + 1e-9)) * step};
}

std::string Axes(const ChartView& view) {
  std::string svg;
  const double value_step = NiceStep(view.high - view.low, 4);
  for (const double value : Ticks(view.low, view.high, value_step)) {
    svg += fmt::format(
        "<path class=\"grid\" d=\"M{0} {1:.1f}H{2}\"/><text class=\"soft\" x=\"{3}\" "
        "y=\"{4:.1f}\" text-anchor=\"end\">{5}</text>",
        kLeft, view.Y(value), kWidth - kRight, kLeft - 6, view.Y(value) + 4,
        TickText(value, value_step));
  }
  const double time_step = NiceStep(view.end_s, 10);
  for (const double t_s : Ticks(0, view.end_s, time_step)) {
    svg +=
        fmt::format("<text class=\"soft\" x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">{}</text>",
                    view.X(t_s), kHeight - kBottom + 16, TickText(t_s, time_step));
  }
  svg += fmt::format("<text class=\"soft\" x=\"{}\" y=\"{}\" text-anchor=\"end\">time [s]</text>\n",
                     kWidth - kRight, kHeight - 4);
  return svg;
}

std::string Steps(const TimeChart& chart, const ChartView& view) {
  std::string svg;
  double free_from = 0;
  for (const auto& [t_s, name] : chart.steps) {
    const double x = view.X(t_s);
    svg +=
        fmt::format("<path class=\"step\" d=\"M{:.1f} {}V{}\"/>", x, kTop - 12, kHeight - kBottom);
    if (x < free_from) continue;
    svg += fmt::format("<text class=\"soft\" x=\"{:.1f}\" y=\"{}\">{}</text>", x + 4, kTop - 5,
                       EscapeHtml(name));
    free_from = x + 12 + 6.5 * static_cast<double>(name.size());
  }
  return svg;
}

std::string Limits(const TimeChart& chart, const ChartView& view) {
  std::string svg;
  for (const ChartLimit& limit : chart.limits) {
    const double y = view.Y(limit.value);
    svg += fmt::format(
        "<path class=\"limit\" d=\"M{0} {1:.1f}H{2}\"/><text class=\"limit-name\" "
        "x=\"{2}\" y=\"{3:.1f}\" text-anchor=\"end\">{4}</text>",
        kLeft, y, kWidth - kRight, y - 4, EscapeHtml(limit.name));
  }
  return svg;
}

std::string Line(const TimeSeries& series, int number, const std::string& unit,
                 const ChartView& view) {
  std::string path;
  std::string dots;
  bool pen_down = false;
  for (const auto& [t_s, value] : series.points) {
    if (!HasValue(value)) {
      pen_down = false;
      continue;
    }
    const double x = view.X(t_s);
    const double y = view.Y(*value);
    path += fmt::format("{}{:.1f} {:.1f}", pen_down ? 'L' : 'M', x, y);
    pen_down = true;
    dots += fmt::format(
        "<circle class=\"dot{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.5\"><title>"
        "{} {}{} at {:.2f} s</title></circle>",
        number, x, y, EscapeHtml(series.name), ShortNumber(value),
        EscapeHtml(unit.empty() ? "" : " " + unit), t_s);
  }
  return fmt::format("<path class=\"line{}\" d=\"{}\"/>{}\n", number, path, dots);
}

std::string Heading(const TimeChart& chart) {
  std::string svg =
      fmt::format("<text class=\"title\" x=\"0\" y=\"15\">{}{}</text>", EscapeHtml(chart.title),
                  chart.unit.empty() ? "" : fmt::format(" [{}]", EscapeHtml(chart.unit)));
  if (chart.series.size() < 2) return svg;
  double x = kWidth - kRight;
  for (int i = static_cast<int>(chart.series.size()) - 1; i >= 0; --i) {
    const std::string& name = chart.series[i].name;
    svg += fmt::format("<text x=\"{:.1f}\" y=\"15\" text-anchor=\"end\">{}</text>", x,
                       EscapeHtml(name));
    x -= 7.4 * static_cast<double>(name.size()) + 8;
    svg += fmt::format("<path class=\"line{}\" d=\"M{:.1f} 11h22\"/>", i + 1, x - 22);
    x -= 40;
  }
  return svg;
}

}  // namespace

std::optional<std::string> TimeChartSvg(const TimeChart& chart, double end_s) {
  const std::optional<ChartView> view = Fit(chart, end_s);
  if (!view) return std::nullopt;
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"chart\" role=\"img\" aria-label=\"{} over "
      "time\" viewBox=\"0 0 {} {}\">\n",
      EscapeHtml(chart.title), kWidth, kHeight);
  svg += Heading(chart) + Axes(*view) + Steps(chart, *view) + Limits(chart, *view);
  for (std::size_t i = 0; i < chart.series.size(); ++i) {
    svg += Line(chart.series[i], static_cast<int>(i) + 1, chart.unit, *view);
  }
  return svg + "</svg>\n";
}

}  // namespace horopter::scenarios
