// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "hardware/types/config_error.h"
#include "scenarios/cli/motion_arguments.h"
#include "scenarios/cli/option_text.h"
#include "scenarios/cli/render_options.h"
#include "scenarios/format/camera_fields.h"
#include "scenarios/format/fault_fields.h"
#include "scenarios/format/read_text.h"
#include "scenarios/format/suggest.h"
#include "scenarios/render/gaze_list.h"
#include "scenarios/render/request_checks.h"

namespace horopter::scenarios {
namespace {

constexpr double kFarthest_m = 100;

void SetSize(const std::string& text, CameraSpec& camera) {
  char end = 0;
  const int read = std::sscanf(text.c_str(), "%dx%d%c", &camera.width, &camera.height, &end);
  const auto fits = [](int pixels) { return pixels >= 16 && pixels <= 4096; };
  if (read == 2 && fits(camera.width) && fits(camera.height)) return;
  RefuseOption("--size", text, "must be WIDTHxHEIGHT, from 16 to 4096 each, e.g. 320x240");
}

Interval Single(const std::string& option, const std::string& text) {
  if (text.empty()) return {};
  const Interval interval = ParseInterval(option, text);
  if (interval.low != interval.high) {
    RefuseOption(option, text, "is a range: say how many gazes to draw from it with --random N");
  }
  return interval;
}

PoseTable ByAxes(const RenderArguments& a) {
  const std::vector<std::string> names(hardware::kHeadAxisNames.begin(),
                                       hardware::kHeadAxisNames.end());
  PoseTable table;
  table.rows.emplace_back();
  for (const std::string& text : a.axes) {
    const auto [name, values] = NamedNumbers("--axis", text, "NAME=DEG, e.g. left_pan=-3");
    if (values.size() != 1) RefuseOption("--axis", text, "must be NAME=DEG: one number");
    if (std::find(names.begin(), names.end(), name) == names.end()) {
      RefuseOption("--axis", text, "is no axis of a head" + DidYouMean(name, names));
    }
    table.columns.push_back(name + "_deg");
    table.rows[0].push_back(values[0]);
  }
  return table;
}

PoseTable ByGazes(const RenderArguments& a, const RobotDescription& robot) {
  PoseTable table{"", {"pan_deg", "tilt_deg", "vergence_deg"}, {}};
  std::vector<Gaze> gazes;
  if (a.random == 0) {
    gazes = {{Single("--pan", a.pan).low, Single("--tilt", a.tilt).low,
              Single("--vergence", a.vergence).low}};
  } else {
    GazeBounds bounds;
    if (!a.pan.empty()) bounds.pan_deg = ParseInterval("--pan", a.pan);
    if (!a.tilt.empty()) bounds.tilt_deg = ParseInterval("--tilt", a.tilt);
    if (!a.vergence.empty()) bounds.vergence_deg = ParseInterval("--vergence", a.vergence);
    gazes = SampleGazes(bounds, a.random, a.seed.value_or(0), HeadReach(robot));
  }
  for (const Gaze& g : gazes) table.rows.push_back({g.pan_deg, g.tilt_deg, g.vergence_deg});
  return table;
}

/// Adds columns that are the same in every row.
void AddBodies(const RenderArguments& a, PoseTable& table) {
  static const char* const kParts[] = {"x_m", "y_m", "z_m", "yaw_deg", "pitch_deg", "roll_deg"};
  for (const std::string& text : a.bodies) {
    const std::string form = "NAME=X,Y,Z[,YAW,PITCH,ROLL] in m and deg, e.g. board=0.8,0,0.4,180";
    const auto [name, values] = NamedNumbers("--body", text, form);
    if (values.size() < 3 || values.size() > 6) RefuseOption("--body", text, "must be " + form);
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (i < 3 && std::abs(values[i]) > kFarthest_m) {
        RefuseOption("--body", text, fmt::format("must be within {:g} m", kFarthest_m));
      }
      table.columns.push_back(name + "." + kParts[i]);
      for (auto& row : table.rows) row.push_back(values[i]);
    }
  }
}

PoseTable PosesOf(const RenderArguments& a, const RobotDescription& robot) {
  PoseTable table = !a.poses.empty()  ? DecodePoseTable(ReadText(a.poses), a.poses)
                    : !a.axes.empty() ? ByAxes(a)
                                      : ByGazes(a, robot);
  AddBodies(a, table);
  return table;
}

std::optional<GeneratedRoom> RoomOf(const RenderArguments& a) {
  if (a.obstacles.empty()) return std::nullopt;
  GeneratedRoom room;
  const Interval count = ParseInterval("--obstacles", a.obstacles);
  const auto whole = [](double n) { return n == std::floor(n) && n >= 0 && n <= 30; };
  if (!whole(count.low) || !whole(count.high)) {
    RefuseOption("--obstacles", a.obstacles, "must be whole numbers from 0 to 30: N or MIN:MAX");
  }
  room.spec.min_obstacles = static_cast<int>(count.low);
  room.spec.max_obstacles = static_cast<int>(count.high);
  room.spec.path = a.blocked ? "blocked" : "free";
  if (a.clearance_m) room.spec.clearance_m = *a.clearance_m;
  if (!a.goal.empty()) {
    const auto goal = Numbers(a.goal);
    if (goal.size() != 2) RefuseOption("--goal", a.goal, "must be X,Y in metres, e.g. 3,0");
    room.goal_m = {goal[0], goal[1]};
  }
  return room;
}

std::optional<TableSpec> TableOf(const RenderArguments& a) {
  const bool any =
      a.clutter || a.occluded || !a.background.empty() || a.brightness || a.colour_temperature_k;
  if (!any) return std::nullopt;
  TableSpec table;
  table.clutter = a.clutter.value_or(table.clutter);
  table.occluded = a.occluded.value_or(table.occluded);
  table.background = a.background;
  table.brightness = a.brightness.value_or(table.brightness);
  table.colour_temperature_k = a.colour_temperature_k.value_or(table.colour_temperature_k);
  return table;
}

}  // namespace

RenderRequest RequestOf(const RenderArguments& a) {
  RenderRequest request;
  request.scene = a.scene;
  CheckScene(request);
  request.robot = a.robot.empty() ? std::filesystem::path(a.scene).begin()->string() : a.robot;
  request.room = RoomOf(a);
  request.seed = a.seed;
  if (request.room && !a.seed) request.seed = 0;  // a generated room always has one
  request.table = TableOf(a);
  request.pairs = a.cameras;
  if (!a.camera_file.empty()) {
    request.camera = ReadCameraFile(a.camera_file, request.camera);
  } else {
    request.camera.profile = sim::CameraProfile::Named(a.profile);
  }
  if (!a.size.empty()) SetSize(a.size, request.camera);
  request.motion = MotionOf(a);
  if (request.motion) SetRate(a, request.camera.profile);
  if (!a.faults.empty()) request.faults = ReadFaultsFile(a.faults);
  request.supersample = a.supersample;
  request.gl = a.gl;
  request.truth = a.truth;
  request.png16 = a.png16;
  request.between = a.between;
  request.views = a.views;
  request.poses = PosesOf(a, RobotOf(request));
  return request;
}

}  // namespace horopter::scenarios
