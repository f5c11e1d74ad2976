// SPDX-License-Identifier: Apache-2.0
#include "scenarios/results/plan_svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "scenarios/results/axis.h"
#include "scenarios/results/text.h"

namespace horopter::scenarios {
namespace {

using Point = std::pair<double, double>;  ///< metres, or pixels after View::Map

constexpr double kPlotWidth = 640;
constexpr double kMaxPlotHeight = 560;
constexpr double kLeft = 52;
constexpr double kRight = 18;
constexpr double kTop = 16;
constexpr double kBelowAxis = 46;
constexpr double kLegendRow = 22;

constexpr char kStyle[] = R"(<style>
.plan{--floor:#fbfaf7;--grid:#e6e3dc;--ink:#22262b;--soft:#5c6670;--wall:#59616b;--thing:#c9c4b8;
--thing-edge:#8d877a;--obstacle:#d1342c;--board:#6b4fbb;--path:#0b62c4;--odometry:#b35900;
--goal:#1a7f37;--halo:#ffffff;font:13px system-ui,sans-serif}
@media (prefers-color-scheme:dark){.plan{--floor:#1d2127;--grid:#2d333b;--ink:#e6e9ee;--soft:#9aa4b0;
--wall:#8b949e;--thing:#444a52;--thing-edge:#6b737d;--obstacle:#f0524a;--board:#a48bf0;
--path:#5aa7ff;--odometry:#f0a04b;--goal:#4ac26b;--halo:#14171b}}
@media print{.plan{--floor:#fff;--grid:#ddd;--ink:#000;--soft:#444;--wall:#555;--thing:#ccc;
--thing-edge:#888;--obstacle:#d1342c;--board:#6b4fbb;--path:#0b62c4;--odometry:#b35900;
--goal:#1a7f37;--halo:#fff}}
.plan text{fill:var(--ink)}.plan .soft{fill:var(--soft);font-size:12px}
.plan .grid{stroke:var(--grid);stroke-width:1}.plan .floor{fill:var(--floor);stroke:var(--grid)}
.plan .name{font-size:11px;text-anchor:middle;paint-order:stroke;stroke:var(--halo);
stroke-width:3px;stroke-linejoin:round}
.plan .furniture{fill:var(--thing);stroke:var(--thing-edge)}
.plan .wall{fill:var(--wall);stroke:var(--wall)}
.plan .obstacle{fill:var(--obstacle);stroke:var(--obstacle)}
.plan .board{fill:var(--board);stroke:var(--board);stroke-width:2}
.plan .swept{fill:none;stroke:var(--path);stroke-opacity:.16;stroke-linecap:round;
stroke-linejoin:round}
.plan .true{fill:none;stroke:var(--path);stroke-width:2.5;stroke-linejoin:round}
.plan .odometry{fill:none;stroke:var(--odometry);stroke-width:2;stroke-dasharray:6 4}
.plan .robot{fill:var(--halo);fill-opacity:.75;stroke:var(--ink);stroke-width:1.5}
.plan .heading{stroke:var(--ink);stroke-width:2}
.plan .goal{fill:none;stroke:var(--goal);stroke-width:2.5}
.plan .waypoint{fill:var(--halo);stroke:var(--goal);stroke-width:2}
.plan .mark{fill:var(--path);stroke:var(--halo);stroke-width:1.5}
.plan .scale{stroke:var(--ink);stroke-width:2;fill:none}
</style>
)";

/// Smallest box that holds everything drawn, in metres.
class Extent {
 public:
  void Add(double x, double y, double margin = 0) {
    if (!std::isfinite(x) || !std::isfinite(y)) return;
    low_ = {std::min(low_.first, x - margin), std::min(low_.second, y - margin)};
    high_ = {std::max(high_.first, x + margin), std::max(high_.second, y + margin)};
  }
  bool empty() const { return low_.first > high_.first; }
  Point low() const { return low_; }
  Point high() const { return high_; }

 private:
  static constexpr double kInf = std::numeric_limits<double>::infinity();
  Point low_{kInf, kInf};
  Point high_{-kInf, -kInf};
};

Extent ExtentOf(const PlanRecord& plan) {
  Extent extent;
  for (const PlanShape& shape : plan.shapes) {
    for (const auto& [x, y] : shape.outline_m) extent.Add(x, y);
  }
  for (const auto& [x, y] : plan.goals_m) extent.Add(x, y, 0.2);
  for (const auto& [x, y] : plan.waypoints_m) extent.Add(x, y, 0.1);
  const double radius = std::max(plan.robot_radius_m, 0.05);
  extent.Add(0, 0, radius);
  for (const PathPoint& p : plan.path) {
    extent.Add(p.odometry.x_m, p.odometry.y_m, radius);
    if (p.true_pose) extent.Add(p.true_pose->x_m, p.true_pose->y_m, radius);
  }
  const double margin = 0.03 * std::max(extent.high().first - extent.low().first,
                                        extent.high().second - extent.low().second);
  const auto [low_x, low_y] = extent.low();
  const auto [high_x, high_y] = extent.high();
  extent.Add(low_x, low_y, margin);
  extent.Add(high_x, high_y, margin);
  return extent;
}

/// From metres to the picture.
class View {
 public:
  explicit View(const Extent& extent)
      : low_(extent.low()),
        high_(extent.high()),
        scale_(std::min(kPlotWidth / (high_.first - low_.first),
                        kMaxPlotHeight / (high_.second - low_.second))) {}

  Point Map(double x_m, double y_m) const {
    return {kLeft + (x_m - low_.first) * scale_, kTop + (high_.second - y_m) * scale_};
  }
  double Pixels(double m) const { return m * scale_; }
  double width() const { return Pixels(high_.first - low_.first); }
  double height() const { return Pixels(high_.second - low_.second); }
  Point low() const { return low_; }
  Point high() const { return high_; }

 private:
  Point low_;
  Point high_;
  double scale_;
};

std::string PointList(const View& view, const std::vector<Point>& points_m) {
  std::string list;
  for (const auto& [x_m, y_m] : points_m) {
    const auto [x, y] = view.Map(x_m, y_m);
    list += fmt::format("{}{:.1f},{:.1f}", list.empty() ? "" : " ", x, y);
  }
  return list;
}

std::string Axes(const View& view) {
  const double right = kLeft + view.width();
  const double bottom = kTop + view.height();
  std::string svg = fmt::format(
      "<rect class=\"floor\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>\n",
      kLeft, kTop, view.width(), view.height());
  const double step = NiceStep(
      std::max(view.high().first - view.low().first, view.high().second - view.low().second), 8);
  for (const double x_m : Ticks(view.low().first, view.high().first, step)) {
    const double x = view.Map(x_m, 0).first;
    svg += fmt::format(
        "<path class=\"grid\" d=\"M{0:.1f} {1:.1f}V{2:.1f}\"/>"
        "<text class=\"soft\" x=\"{0:.1f}\" y=\"{3:.1f}\" text-anchor=\"middle\">"
        "{4}</text>\n",
        x, kTop, bottom, bottom + 16, TickText(x_m, step));
  }
  for (const double y_m : Ticks(view.low().second, view.high().second, step)) {
    const double y = view.Map(0, y_m).second;
    svg += fmt::format(
        "<path class=\"grid\" d=\"M{0:.1f} {1:.1f}H{2:.1f}\"/>"
        "<text class=\"soft\" x=\"{3:.1f}\" y=\"{4:.1f}\" text-anchor=\"end\">{5}"
        "</text>\n",
        kLeft, y, right, kLeft - 6, y + 4, TickText(y_m, step));
  }
  svg += fmt::format(
      "<text class=\"soft\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">"
      "x, ahead at the start [m] \u2192</text>\n",
      (kLeft + right) / 2, bottom + 35);
  svg += fmt::format(
      "<text class=\"soft\" transform=\"translate(14 {:.1f}) rotate(-90)\" "
      "text-anchor=\"middle\">y, left [m] \u2192</text>\n",
      (kTop + bottom) / 2);
  return svg;
}

std::string KindClass(const std::string& kind) {
  for (const char* known : {"wall", "obstacle", "board"}) {
    if (kind == known) return known;
  }
  return "furniture";
}

Point Centre(const std::vector<Point>& outline_m) {
  Extent extent;
  for (const auto& [x, y] : outline_m) extent.Add(x, y);
  return {(extent.low().first + extent.high().first) / 2,
          (extent.low().second + extent.high().second) / 2};
}

std::string Shapes(const View& view, const PlanRecord& plan) {
  std::string svg;
  std::string names;
  for (const PlanShape& shape : plan.shapes) {
    if (shape.outline_m.empty()) continue;
    const std::string name = EscapeHtml(shape.name);
    svg += fmt::format("<polygon class=\"{}\" points=\"{}\"><title>{}</title></polygon>\n",
                       KindClass(shape.kind), PointList(view, shape.outline_m), name);
    if (shape.kind == "wall" || shape.name.empty()) continue;
    const auto [x_m, y_m] = Centre(shape.outline_m);
    const auto [x, y] = view.Map(x_m, y_m);
    names +=
        fmt::format("<text class=\"name\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", x, y + 4, name);
  }
  return svg + names;
}

std::vector<Point> OdometryOf(const PlanRecord& plan) {
  std::vector<Point> points;
  for (const PathPoint& p : plan.path) points.emplace_back(p.odometry.x_m, p.odometry.y_m);
  return points;
}

std::vector<Point> TruePathOf(const PlanRecord& plan) {
  std::vector<Point> points;
  for (const PathPoint& p : plan.path) {
    if (p.true_pose) points.emplace_back(p.true_pose->x_m, p.true_pose->y_m);
  }
  return points;
}

std::string Polyline(const View& view, const char* kind, const std::vector<Point>& points,
                     const std::string& attributes = "") {
  if (points.empty()) return "";
  return fmt::format("<polyline class=\"{}\" {}points=\"{}\"/>\n", kind, attributes,
                     PointList(view, points));
}

std::string Robot(const View& view, const hardware::Pose2& pose, double radius_m,
                  const char* title) {
  const auto [x, y] = view.Map(pose.x_m, pose.y_m);
  const double radius = std::max(5.0, view.Pixels(radius_m));
  return fmt::format(
      "<g><title>{}</title><circle class=\"robot\" cx=\"{:.1f}\" cy=\"{:.1f}\" "
      "r=\"{:.1f}\"/><path class=\"heading\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\"/>"
      "</g>\n",
      title, x, y, radius, x, y, x + radius * std::cos(pose.heading_rad),
      y - radius * std::sin(pose.heading_rad));
}

std::string Paths(const View& view, const PlanRecord& plan) {
  const std::vector<Point> truth = TruePathOf(plan);
  const std::vector<Point> odometry = OdometryOf(plan);
  std::string svg =
      Polyline(view, "swept", truth.empty() ? odometry : truth,
               fmt::format("stroke-width=\"{:.1f}\" ", view.Pixels(2 * plan.robot_radius_m)));
  svg += Polyline(view, "true", truth) + Polyline(view, "odometry", odometry);
  if (plan.path.empty()) return svg + Robot(view, {}, plan.robot_radius_m, "start");
  const auto pose = [](const PathPoint& p) { return p.true_pose.value_or(p.odometry); };
  return svg + Robot(view, pose(plan.path.front()), plan.robot_radius_m, "start") +
         Robot(view, pose(plan.path.back()), plan.robot_radius_m, "end");
}

std::string GoalSymbol(double x, double y) {
  return fmt::format(
      "<path class=\"goal\" d=\"M{0:.1f} {1:.1f}m-8 0a8 8 0 1 0 16 0a8 8 0 1 0 -16 0"
      "M{0:.1f} {1:.1f}m-12 0h24m-12 -12v24\"/>",
      x, y);
}

std::string WaypointSymbol(double x, double y) {
  return fmt::format("<path class=\"waypoint\" d=\"M{:.1f} {:.1f}l6 6l-6 6l-6 -6z\"/>", x, y - 6);
}

std::string Targets(const View& view, const PlanRecord& plan) {
  std::string svg;
  int number = 0;
  for (const auto& [x_m, y_m] : plan.waypoints_m) {
    const auto [x, y] = view.Map(x_m, y_m);
    svg += fmt::format(
        "<g><title>waypoint {0}: x {1:.2f} m, y {2:.2f} m</title>{3}"
        "<text class=\"name\" x=\"{4:.1f}\" y=\"{5:.1f}\">w{0}</text></g>\n",
        ++number, x_m, y_m, WaypointSymbol(x, y), x, y - 11);
  }
  for (const auto& [x_m, y_m] : plan.goals_m) {
    const auto [x, y] = view.Map(x_m, y_m);
    svg += fmt::format("<g><title>goal: x {:.2f} m, y {:.2f} m</title>{}</g>\n", x_m, y_m,
                       GoalSymbol(x, y));
  }
  return svg;
}

std::string Marks(const View& view, const std::vector<PlanMark>& marks) {
  std::string svg;
  for (const PlanMark& mark : marks) {
    const auto [x, y] = view.Map(mark.pose.x_m, mark.pose.y_m);
    const std::string symbol = fmt::format(
        "<g><title>frame {0}</title><circle class=\"mark\" cx=\"{1:.1f}\" cy=\"{2:.1f}\" r=\"4\"/>"
        "</g>",
        EscapeHtml(mark.label), x, y);
    svg += mark.link.empty() ? symbol
                             : fmt::format("<a href=\"{}\">{}</a>", EscapeHtml(mark.link), symbol);
    svg += '\n';
  }
  return svg;
}

std::string ScaleBar(const View& view) {
  const double length_m = NiceStep(view.high().first - view.low().first, 6);
  const double right = kLeft + view.width();
  const double y = kTop + view.height() + 36;
  return fmt::format(
      "<path class=\"scale\" d=\"M{0:.1f} {1:.1f}v-4v8v-4H{2:.1f}v-4v8\"/>"
      "<text x=\"{3:.1f}\" y=\"{4:.1f}\" text-anchor=\"end\">{5} m</text>\n",
      right - view.Pixels(length_m), y, right, right - view.Pixels(length_m) - 6, y + 4,
      TickText(length_m, length_m));
}

struct LegendEntry {
  std::string symbol;  ///< drawn around (14, 0)
  std::string text;
};

std::vector<LegendEntry> LegendOf(const PlanRecord& plan, bool has_marks) {
  std::vector<LegendEntry> entries;
  const auto line = [](const char* kind) {
    return fmt::format("<path class=\"{}\" d=\"M0 0H28\"/>", kind);
  };
  if (!TruePathOf(plan).empty()) entries.push_back({line("true"), "true path"});
  if (!plan.path.empty()) {
    entries.push_back({line("odometry"), "odometry"});
    entries.push_back({"<path class=\"swept\" stroke-width=\"14\" d=\"M9 0H19\"/>", "swept width"});
  }
  if (has_marks)
    entries.push_back({"<circle class=\"mark\" cx=\"14\" cy=\"0\" r=\"4\"/>", "frame shown"});
  if (!plan.goals_m.empty()) entries.push_back({GoalSymbol(14, 0), "goal"});
  if (!plan.waypoints_m.empty()) {
    entries.push_back({WaypointSymbol(14, 0), "intermediate waypoint"});
  }
  std::map<std::string, bool> seen;
  for (const PlanShape& shape : plan.shapes) {
    const std::string kind = KindClass(shape.kind);
    if (std::exchange(seen[kind], true)) continue;
    entries.push_back(
        {fmt::format("<rect class=\"{}\" x=\"6\" y=\"-6\" width=\"16\" height=\"12\"/>", kind),
         kind});
  }
  return entries;
}

/// Rows of symbols and words below the axes. @return the SVG and the height it takes
std::pair<std::string, double> Legend(const View& view, const PlanRecord& plan, bool has_marks) {
  const double right = kLeft + view.width();
  double x = kLeft;
  double y = kTop + view.height() + kBelowAxis + kLegendRow / 2;
  std::string svg;
  for (const LegendEntry& entry : LegendOf(plan, has_marks)) {
    const double width = 28 + 6 + 7.3 * static_cast<double>(entry.text.size()) + 16;
    if (x > kLeft && x + width > right + kRight) x = kLeft, y += kLegendRow;
    svg += fmt::format(
        "<g transform=\"translate({:.1f} {:.1f})\">{}<text x=\"34\" y=\"4\">{}</text>"
        "</g>\n",
        x, y, entry.symbol, entry.text);
    x += width;
  }
  return {svg, y + kLegendRow / 2};
}

}  // namespace

std::string PlanSvg(const PlanRecord& plan, const std::vector<PlanMark>& marks) {
  const View view(ExtentOf(plan));
  const auto [legend, bottom] = Legend(view, plan, !marks.empty());
  const double width = std::max(kLeft + view.width() + kRight, 360.0);
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"plan\" role=\"img\" "
             "aria-label=\"Plan of the room with the driven path\" "
             "viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" height=\"{1:.0f}\">\n",
             width, bottom + 6) +
         kStyle + Axes(view) + Shapes(view, plan) + Paths(view, plan) + Marks(view, marks) +
         Targets(view, plan) + ScaleBar(view) + legend + "</svg>\n";
}

}  // namespace horopter::scenarios
