// SPDX-License-Identifier: Apache-2.0
#include "scenarios/format/robot_description.h"

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "control/kinematics/look_at.h"
#include "hardware/types/config_error.h"
#include "scenarios/format/field_parser.h"
#include "scenarios/format/field_schema.h"
#include "scenarios/format/read_text.h"
#include "scenarios/format/yaml_document.h"

namespace horopter::scenarios {
namespace {

constexpr double kRadPerDeg = M_PI / 180;
constexpr Range kLength{0, 10};
constexpr Range kPositive{0, 1e6, true};
constexpr Range kCoordinate{-10, 10};

/// An axis as the file has it.
struct AxisKeys {
  double min_deg = 0;
  double max_deg = 0;
  double max_speed_deg_s = 0;
  double max_acceleration_deg_s2 = 0;

  hardware::AxisLimits Limits() const {
    return {min_deg * kRadPerDeg, max_deg * kRadPerDeg, max_speed_deg_s * kRadPerDeg,
            max_acceleration_deg_s2 * kRadPerDeg};
  }
};

/// The file's values that become something else in RobotDescription.
struct FileKeys {
  WheelsDescription wheels;
  Eigen::Vector3d neck_m = Eigen::Vector3d::Zero();
  std::map<std::string, AxisKeys> axes;
};

void VisitWheels(FieldVisitor& v, WheelsDescription& w) {
  v.Number({"metres_per_pulse", "m", "Ground covered per encoder pulse.", true}, {0, 1, true},
           w.properties.metres_per_pulse);
  v.Integral({"pulses_per_turn", "", "Encoder pulses per turn of a driven wheel.", true}, {1, 1e7},
             w.pulses_per_turn);
  v.Number({"effective_track_m", "m", "Wheel distance of the unicycle that turns alike.", true},
           {0, 5, true}, w.properties.effective_track_m);
  v.Number({"max_speed_m_s", "m/s", "Fastest a side drives.", true}, kPositive,
           w.properties.max_wheel_speed_m_s);
  v.Number({"max_acceleration_m_s2", "m/s^2", "Fastest a side speeds up.", true}, kPositive,
           w.max_acceleration_m_s2);
  v.Number({"deadman_s", "s", "Without a command for this long, the base stops.", true},
           {0, 60, true}, w.deadman_s);
}

void VisitAxis(FieldVisitor& v, AxisKeys& a) {
  v.Number({"min_deg", "deg", "Rightmost, or highest.", true}, {-180, 0}, a.min_deg);
  v.Number({"max_deg", "deg", "Leftmost, or lowest.", true}, {0, 180}, a.max_deg);
  v.Number({"max_speed_deg_s", "deg/s", "Fastest it turns.", true}, kPositive, a.max_speed_deg_s);
  v.Number({"max_acceleration_deg_s2", "deg/s^2", "Fastest it speeds up.", true}, kPositive,
           a.max_acceleration_deg_s2);
}

template <typename T>
std::vector<std::string> KeysOf(const std::map<std::string, T>& map) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : map) keys.push_back(key);
  return keys;
}

NamedMap AxisMap(std::map<std::string, AxisKeys>& axes) {
  std::string names;
  for (std::string_view name : hardware::kHeadAxisNames) {
    names += (names.empty() ? "" : "|") + std::string(name);
  }
  return {{"axes", "", "What each axis of the head can do; an axis left out does not exist."},
          {names, "one of " + names, 20},
          KeysOf(axes),
          [&axes](const std::string& name) -> FieldTable {
            return [&axis = axes[name]](FieldVisitor& v) { VisitAxis(v, axis); };
          }};
}

void VisitHead(FieldVisitor& v, RobotDescription& r, FileKeys& keys) {
  v.Numbers({"neck_m", "m", "Neck in the base frame: forward, left, above the floor.", true},
            kCoordinate, {keys.neck_m.data(), 3});
  v.Number({"pan_to_tilt_m", "m", "Neck's tilt axis above its pan axis."}, kLength,
           r.head_geometry.pan_to_tilt_m);
  v.Number({"pan_to_tilt_forward_m", "m", "Neck's tilt axis before its pan axis."}, kCoordinate,
           r.head_geometry.pan_to_tilt_forward_m);
  v.Number({"tilt_to_eyes_m", "m", "Eyes above the neck's tilt axis."}, kLength,
           r.head_geometry.tilt_to_eyes_m);
  v.Number({"baseline_m", "m", "Between the eyes' pan axes.", true}, {0, 2, true},
           r.head_geometry.baseline_m);
  v.Number({"axis_to_optical_centre_m", "m", "Optical centre before its axis."}, kLength,
           r.head_geometry.axis_to_optical_centre_m);
  v.Number({"encoder_step_deg", "deg", "One encoder position; 0 = continuous."}, {0, 5},
           r.encoder_step_deg);
  v.Map(AxisMap(keys.axes));
}

void VisitCameras(FieldVisitor& v, CameraPairDescription& c) {
  const TextRule camera{"[A-Za-z_][A-Za-z0-9_.-]*", "the name of a camera of the model", 80};
  v.Text({"left", "", "The left camera in the robot's MuJoCo model.", true}, camera, c.left);
  v.Text({"right", "", "The right one.", true}, camera, c.right);
  v.Integral({"width_px", "px", "Columns of the sensor.", true}, {16, 4096}, c.width_px);
  v.Integral({"height_px", "px", "Rows of the sensor.", true}, {16, 4096}, c.height_px);
  v.Number({"horizontal_fov_deg", "deg", "Of either camera.", true}, {5, 150},
           c.horizontal_fov_deg);
  v.Number({"above_m", "m", "Above the head's optical centres."}, kCoordinate, c.above_m);
  v.Number({"ahead_m", "m", "Before the head's optical centres."}, kCoordinate, c.ahead_m);
}

NamedMap CameraMap(std::map<std::string, CameraPairDescription>& cameras) {
  return {{"cameras", "", "Pairs of cameras, by name.", true},
          {"[a-z][a-z0-9_]*", "lower-case letters, digits and '_'", 40},
          KeysOf(cameras),
          [&cameras](const std::string& name) -> FieldTable {
            return [&pair = cameras[name]](FieldVisitor& v) { VisitCameras(v, pair); };
          }};
}

FieldTable TableOf(RobotDescription& robot, FileKeys& keys) {
  return [&](FieldVisitor& v) {
    v.Text({"name", "", "Of the robot.", true}, {"", "", 80}, robot.name);
    v.Number({"radius_m", "m", "Circle about the base's origin that holds the body.", true},
             {0, 10, true}, robot.radius_m);
    v.Number({"height_m", "m", "Above the ground, head included.", true}, {0, 10, true},
             robot.height_m);
    v.Section({"wheels", "", "Two driven sides; left out for a robot that does not roll."},
              [&keys](FieldVisitor& w) { VisitWheels(w, keys.wheels); });
    v.Section({"head", "", "Where the eyes are and how they turn.", true},
              [&](FieldVisitor& w) { VisitHead(w, robot, keys); });
    v.Map(CameraMap(robot.cameras));
  };
}

void Complete(const FileKeys& keys, const ParseReport& report, RobotDescription& robot) {
  if (report.marks.count("wheels") > 0) robot.wheels = keys.wheels;
  robot.head_geometry.X_BN.translation() = keys.neck_m;
  for (int axis = 0; axis < hardware::kHeadAxisCount; ++axis) {
    const auto found = keys.axes.find(std::string(hardware::kHeadAxisNames[axis]));
    if (found != keys.axes.end()) robot.head_limits[axis] = found->second.Limits();
  }
}

}  // namespace

hardware::CameraModel CameraPairDescription::Model() const {
  return hardware::CameraModel::FromHorizontalFov(width_px, height_px,
                                                  horizontal_fov_deg * kRadPerDeg);
}

const CameraPairDescription& RobotDescription::Cameras(const std::string& pair) const {
  if (pair.empty() && cameras.size() == 1) return cameras.begin()->second;
  const auto found = cameras.find(pair.empty() ? "eyes" : pair);
  if (found != cameras.end()) return found->second;
  std::string names;
  for (const auto& [key, value] : cameras) names += (names.empty() ? "" : ", ") + key;
  throw hardware::ConfigError({{"camera", pair, "must be one of " + name + "'s pairs: " + names}});
}

hardware::HeadGeometry RobotDescription::GeometryOf(const CameraPairDescription& pair) const {
  if (pair.above_m == 0 && pair.ahead_m == 0) return head_geometry;
  return control::ForPair(head_geometry, {pair.above_m, pair.ahead_m});
}

RobotDescription LoadRobotDescription(const std::filesystem::path& path) {
  return ParseRobotDescription(ReadText(path), path.string());
}

RobotDescription ParseRobotDescription(const std::string& text, const std::string& name) {
  const YamlNode root = ParseYaml(text, name);
  RobotDescription robot;
  robot.file = name;
  FileKeys keys;
  ParseReport report;
  ParseFields(root, TableOf(robot, keys), report);
  if (report.diagnostics.empty() && robot.cameras.empty()) {
    report.Add(root.mark, "cameras: at least one pair is needed");
  }
  ThrowIfAny(std::move(report.diagnostics));
  Complete(keys, report, robot);
  return robot;
}

nlohmann::json RobotSchema() {
  RobotDescription robot;
  FileKeys keys;
  nlohmann::json schema = FieldSchema(TableOf(robot, keys));
  schema["$schema"] = "http://json-schema.org/draft-07/schema#";
  schema["title"] = "Horopter robot";
  return schema;
}

}  // namespace horopter::scenarios
