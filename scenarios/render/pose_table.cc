// SPDX-License-Identifier: Apache-2.0
#include "scenarios/render/pose_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "hardware/types/config_error.h"
#include "scenarios/dataset/csv.h"
#include "scenarios/dataset/format_error.h"
#include "scenarios/format/suggest.h"

namespace horopter::scenarios {
namespace {

constexpr double kRadians = M_PI / 180;
const std::vector<std::string> kGazeColumns = {"pan_deg", "tilt_deg", "vergence_deg"};
const std::vector<std::string> kBodyColumns = {"x_m",     "y_m",       "z_m",
                                               "yaw_deg", "pitch_deg", "roll_deg"};

std::vector<std::string> AxisColumns() {
  std::vector<std::string> names;
  for (const std::string_view axis : hardware::kHeadAxisNames) {
    names.push_back(std::string(axis) + "_deg");
  }
  return names;
}

std::optional<std::size_t> IndexIn(const std::vector<std::string>& names, const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<std::size_t>(found - names.begin());
}

[[noreturn]] void Refuse(const PoseTable& table, const std::string& column,
                         const std::string& why) {
  const std::string where = table.file.empty() ? "pose" : table.file + ":1: column";
  throw hardware::ConfigError({{where, column, why}});
}

/// Which column holds what.
struct Layout {
  std::array<std::optional<std::size_t>, 3> gaze;
  std::array<std::optional<std::size_t>, hardware::kHeadAxisCount> axis;
  std::map<std::string, std::array<std::optional<std::size_t>, 6>> body;
  bool by_axis = false;
};

std::optional<std::size_t>& Place(Layout& layout, const PoseTable& table,
                                  const std::string& column) {
  static const std::vector<std::string> axes = AxisColumns();
  if (const auto index = IndexIn(kGazeColumns, column)) return layout.gaze[*index];
  if (const auto index = IndexIn(axes, column)) {
    layout.by_axis = true;
    return layout.axis[*index];
  }
  const std::size_t dot = column.rfind('.');
  if (dot != std::string::npos && dot > 0) {
    const std::string part = column.substr(dot + 1);
    if (const auto index = IndexIn(kBodyColumns, part)) {
      return layout.body[column.substr(0, dot)][*index];
    }
    Refuse(table, column, "a body has no such part" + DidYouMean(part, kBodyColumns));
  }
  std::vector<std::string> known = kGazeColumns;
  known.insert(known.end(), axes.begin(), axes.end());
  Refuse(table, column, "is neither gaze, axis nor BODY.x_m" + DidYouMean(column, known));
}

Layout LayoutOf(const PoseTable& table) {
  Layout layout;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    auto& place = Place(layout, table, table.columns[i]);
    if (place) Refuse(table, table.columns[i], "stands twice: keep one of them");
    place = i;
  }
  const bool by_gaze = std::any_of(layout.gaze.begin(), layout.gaze.end(),
                                   [](const auto& column) { return column.has_value(); });
  if (by_gaze && layout.by_axis) {
    Refuse(table, "pan_deg", "a gaze turns the axes that others name: give one or the other");
  }
  for (const auto& [body, columns] : layout.body) {
    for (std::size_t part = 0; part < 3; ++part) {
      if (columns[part]) continue;
      Refuse(table, body, "lacks " + kBodyColumns[part] + ": give x_m, y_m and z_m");
    }
  }
  return layout;
}

double ValueOf(const std::vector<double>& row, const std::optional<std::size_t>& column) {
  return column ? row.at(*column) : 0;
}

hardware::HeadAngles HeadOf(const Layout& layout, const std::vector<double>& row,
                            const HeadReach& reach, const std::string& where) {
  if (!layout.by_axis) {
    const Gaze gaze{ValueOf(row, layout.gaze[0]), ValueOf(row, layout.gaze[1]),
                    ValueOf(row, layout.gaze[2])};
    return reach.AnglesOf(gaze, where);
  }
  hardware::HeadAxisArray angles{};
  for (std::size_t axis = 0; axis < angles.size(); ++axis) {
    angles[axis] = ValueOf(row, layout.axis[axis]) * kRadians;
  }
  const hardware::HeadAngles head = hardware::FromArray(angles);
  reach.Require(head, where);
  return head;
}

}  // namespace

PoseTable DecodePoseTable(std::string_view text, const std::string& name) {
  std::string_view header = text.substr(0, text.find('\n'));
  const CsvTable csv(text, header, name);
  if (csv.rows() == 0) throw FormatError(name + ": no pose in it; add a row below the header");
  PoseTable table;
  table.file = name;
  for (; !header.empty(); header.remove_prefix(std::min(header.size(), header.find(',') + 1))) {
    table.columns.emplace_back(header.substr(0, header.find(',')));
    if (header.find(',') == std::string_view::npos) break;
  }
  for (std::size_t row = 0; row < csv.rows(); ++row) {
    auto& numbers = table.rows.emplace_back();
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      numbers.push_back(csv.Number(row, i));
      if (!std::isfinite(numbers.back())) throw FormatError(csv.At(row, i, "is not finite"));
    }
  }
  return table;
}

std::vector<PosedView> ViewsOf(const PoseTable& table, const HeadReach& reach) {
  const Layout layout = LayoutOf(table);
  std::vector<PosedView> views;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const std::vector<double>& row = table.rows[i];
    const std::string where = table.file.empty() ? "" : fmt::format("{}:{}: ", table.file, i + 2);
    PosedView view{HeadOf(layout, row, reach, where), {}};
    for (const auto& [body, columns] : layout.body) {
      view.bodies[body] = {
          {ValueOf(row, columns[0]), ValueOf(row, columns[1]), ValueOf(row, columns[2])},
          ValueOf(row, columns[3]),
          ValueOf(row, columns[4]),
          ValueOf(row, columns[5])};
    }
    views.push_back(std::move(view));
  }
  return views;
}

}  // namespace horopter::scenarios
