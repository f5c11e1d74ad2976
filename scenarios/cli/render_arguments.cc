// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "hardware/types/config_error.h"
#include "scenarios/cli/render_options.h"
#include "scenarios/format/camera_fields.h"
#include "scenarios/format/read_text.h"
#include "scenarios/format/suggest.h"
#include "scenarios/render/gaze_list.h"
#include "scenarios/render/request_checks.h"

namespace horopter::scenarios {
namespace {

constexpr double kFarthest_m = 100;

[[noreturn]] void Refuse(const std::string& option, const std::string& value,
                         const std::string& why) {
  throw hardware::ConfigError({{option, value, why}});
}

/// Numbers with commas between them; empty when a piece is none.
std::vector<double> Numbers(std::string_view text) {
  std::vector<double> numbers;
  for (;;) {
    const std::string_view piece = text.substr(0, text.find(','));
    double number = 0;
    const auto [end, error] = std::from_chars(piece.data(), piece.data() + piece.size(), number);
    if (error != std::errc() || end != piece.data() + piece.size() || !std::isfinite(number)) {
      return {};
    }
    numbers.push_back(number);
    if (piece.size() == text.size()) return numbers;
    text.remove_prefix(piece.size() + 1);
  }
}

void SetSize(const std::string& text, CameraSpec& camera) {
  char end = 0;
  const int read = std::sscanf(text.c_str(), "%dx%d%c", &camera.width, &camera.height, &end);
  const auto fits = [](int pixels) { return pixels >= 16 && pixels <= 4096; };
  if (read == 2 && fits(camera.width) && fits(camera.height)) return;
  Refuse("--size", text, "must be WIDTHxHEIGHT, from 16 to 4096 each, e.g. 320x240");
}

Interval Single(const std::string& option, const std::string& text) {
  if (text.empty()) return {};
  const Interval interval = ParseInterval(option, text);
  if (interval.low != interval.high) {
    Refuse(option, text, "is a range: say how many gazes to draw from it with --random N");
  }
  return interval;
}

/// "NAME=VALUES" in its two halves.
std::pair<std::string, std::vector<double>> NamedNumbers(const std::string& option,
                                                         const std::string& text,
                                                         const std::string& form) {
  const std::size_t equals = text.find('=');
  if (equals != std::string::npos && equals > 0) {
    auto numbers = Numbers(std::string_view(text).substr(equals + 1));
    if (!numbers.empty()) return {text.substr(0, equals), std::move(numbers)};
  }
  Refuse(option, text, "must be " + form);
}

PoseTable ByAxes(const RenderArguments& a) {
  const std::vector<std::string> names(hardware::kHeadAxisNames.begin(),
                                       hardware::kHeadAxisNames.end());
  PoseTable table;
  table.rows.emplace_back();
  for (const std::string& text : a.axes) {
    const auto [name, values] = NamedNumbers("--axis", text, "NAME=DEG, e.g. left_pan=-3");
    if (values.size() != 1) Refuse("--axis", text, "must be NAME=DEG: one number");
    if (std::find(names.begin(), names.end(), name) == names.end()) {
      Refuse("--axis", text, "is no axis of a head" + DidYouMean(name, names));
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
    if (values.size() < 3 || values.size() > 6) Refuse("--body", text, "must be " + form);
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (i < 3 && std::abs(values[i]) > kFarthest_m) {
        Refuse("--body", text, fmt::format("must be within {:g} m", kFarthest_m));
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

/// "TEXT@SECONDS" in its two halves; without the second it is at the start.
std::pair<std::string, double> Timed(const std::string& option, const std::string& text) {
  const std::size_t at = text.find('@');
  if (at == std::string::npos) return {text, 0};
  const auto seconds = Numbers(std::string_view(text).substr(at + 1));
  if (seconds.size() != 1 || seconds[0] < 0) {
    Refuse(option, text, "must end in @SECONDS, from the start on, e.g. @0.2");
  }
  return {text.substr(0, at), seconds[0]};
}

/// Where a saccade keeps an angle of this name; null when it is none.
double* AngleNamed(const std::string& name, SaccadeCommand& saccade) {
  for (std::size_t i = 0; i < saccade.gaze_deg.size(); ++i) {
    if (name + "_deg" == SaccadeCommand::kGazeKeys[i]) return &saccade.gaze_deg[i];
  }
  for (std::size_t i = 0; i < saccade.axis_deg.size(); ++i) {
    if (name == hardware::kHeadAxisNames[i]) return &saccade.axis_deg[i];
  }
  return nullptr;
}

MotionCommand SaccadeOf(const std::string& text) {
  const std::string form = "NAME=DEG,...[@SECONDS], e.g. pan=10,tilt=-5@0.2";
  const auto [angles, at_s] = Timed("--saccade", text);
  SaccadeCommand saccade;
  for (std::size_t begin = 0; begin <= angles.size();) {
    const std::size_t end = std::min(angles.find(',', begin), angles.size());
    const auto [name, values] = NamedNumbers("--saccade", angles.substr(begin, end - begin), form);
    double* angle = AngleNamed(name, saccade);
    if (angle == nullptr) {
      std::vector<std::string> known = {"pan", "tilt", "vergence"};
      known.insert(known.end(), hardware::kHeadAxisNames.begin(), hardware::kHeadAxisNames.end());
      Refuse("--saccade", name, "is no axis of a head" + DidYouMean(name, known));
    }
    if (*angle != SaccadeCommand::kLeftOut) Refuse("--saccade", name, "stands twice: keep one");
    *angle = values[0];
    begin = end + 1;
  }
  return {at_s, saccade};
}

MotionCommand WalkOf(const std::string& text) {
  const auto [target, at_s] = Timed("--walk", text);
  const auto numbers = Numbers(target);
  if (numbers.size() != 3) {
    Refuse("--walk", text, "must be X,Y,TURN[@SECONDS] in m and deg, e.g. 0.3,0,20");
  }
  return {at_s, WalkToCommand{numbers[0], numbers[1], numbers[2]}};
}

MotionCommand DriveOf(const std::string& text) {
  const auto [speeds, at_s] = Timed("--drive", text);
  const auto numbers = Numbers(speeds);
  if (numbers.size() != 2) {
    Refuse("--drive", text, "must be SPEED,TURN[@SECONDS] in m/s and deg/s, e.g. 0.2,10");
  }
  return {at_s, DriveCommand{numbers[0], numbers[1]}};
}

std::optional<Motion> MotionOf(const RenderArguments& a) {
  if (!a.motion.empty()) return ReadMotionFile(a.motion);
  Motion motion;
  for (const std::string& text : a.saccades) motion.commands.push_back(SaccadeOf(text));
  for (const std::string& text : a.walks) motion.commands.push_back(WalkOf(text));
  for (const std::string& text : a.drives) motion.commands.push_back(DriveOf(text));
  if (motion.commands.empty() && !a.duration_s) {
    if (!a.rate_hz) return std::nullopt;
    Refuse("--rate", fmt::format("{:g}", *a.rate_hz),
           "is a motion's: give --motion, --saccade, --walk, --drive or --duration as well");
  }
  motion.duration_s = a.duration_s.value_or(motion.duration_s);
  return motion;
}

/// Cameras of a motion run at a rate.
void SetRate(const RenderArguments& a, sim::CameraProfile& profile) {
  constexpr double kUsual_hz = 25;
  if (a.rate_hz) profile.timing.rate_hz = *a.rate_hz;
  if (profile.timing.rate_hz <= 0) profile.timing.rate_hz = kUsual_hz;
}

std::optional<GeneratedRoom> RoomOf(const RenderArguments& a) {
  if (a.obstacles.empty()) return std::nullopt;
  GeneratedRoom room;
  const Interval count = ParseInterval("--obstacles", a.obstacles);
  const auto whole = [](double n) { return n == std::floor(n) && n >= 0 && n <= 30; };
  if (!whole(count.low) || !whole(count.high)) {
    Refuse("--obstacles", a.obstacles, "must be whole numbers from 0 to 30: N or MIN:MAX");
  }
  room.spec.min_obstacles = static_cast<int>(count.low);
  room.spec.max_obstacles = static_cast<int>(count.high);
  room.spec.path = a.blocked ? "blocked" : "free";
  if (a.clearance_m) room.spec.clearance_m = *a.clearance_m;
  if (!a.goal.empty()) {
    const auto goal = Numbers(a.goal);
    if (goal.size() != 2) Refuse("--goal", a.goal, "must be X,Y in metres, e.g. 3,0");
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
