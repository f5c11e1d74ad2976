// SPDX-License-Identifier: Apache-2.0
#include "scenarios/format/robot_description.h"

#include <cmath>

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

/// The file's keys that have no member of their own: both eyes' axes are alike, and in degrees.
struct AxisKeys {
  Eigen::Vector3d neck_m = Eigen::Vector3d::Zero();
  double pan_min_deg = 0;
  double pan_max_deg = 0;
  double tilt_min_deg = 0;
  double tilt_max_deg = 0;
  double max_speed_deg_s = 0;
  double max_acceleration_deg_s2 = 0;
};

void VisitBase(FieldVisitor& v, RobotDescription& r) {
  v.Number({"metres_per_pulse", "m", "Ground covered per encoder pulse.", true}, {0, 1, true},
           r.base.metres_per_pulse);
  v.Integral({"pulses_per_turn", "", "Encoder pulses per turn of a driven wheel.", true}, {1, 1e7},
             r.pulses_per_turn);
  v.Number({"wheel_radius_m", "m", "Effective radius of a driven wheel.", true}, {0, 2, true},
           r.wheel_radius_m);
  v.Number({"effective_track_m", "m", "Wheel distance of the unicycle that turns alike.", true},
           {0, 5, true}, r.base.effective_track_m);
  v.Number({"max_wheel_speed_m_s", "m/s", "Fastest a side drives.", true}, kPositive,
           r.base.max_wheel_speed_m_s);
  v.Number({"max_wheel_acceleration_m_s2", "m/s^2", "Fastest a side speeds up.", true}, kPositive,
           r.max_wheel_acceleration_m_s2);
  v.Number({"deadman_s", "s", "Without a command for this long, the base stops.", true},
           {0, 60, true}, r.deadman_s);
  v.Number({"body_radius_m", "m", "Circle about the base's origin that holds the body.", true},
           {0, 10, true}, r.radius_m);
}

void VisitHead(FieldVisitor& v, RobotDescription& r, AxisKeys& axes) {
  v.Number({"neck_x_m", "m", "Neck, forward in the base frame.", true}, kCoordinate,
           axes.neck_m.x());
  v.Number({"neck_y_m", "m", "Neck, to the left.", true}, kCoordinate, axes.neck_m.y());
  v.Number({"neck_z_m", "m", "Neck, above the floor.", true}, kCoordinate, axes.neck_m.z());
  v.Number({"pan_to_tilt_m", "m", "Neck's tilt axis above its pan axis.", true}, kLength,
           r.head_geometry.pan_to_tilt_m);
  v.Number({"tilt_to_eyes_m", "m", "Eyes above the neck's tilt axis.", true}, kLength,
           r.head_geometry.tilt_to_eyes_m);
  v.Number({"baseline_m", "m", "Between the eyes' pan axes.", true}, {0, 2, true},
           r.head_geometry.baseline_m);
  v.Number({"axis_to_optical_centre_m", "m", "Optical centre before its axis.", true}, kLength,
           r.head_geometry.axis_to_optical_centre_m);
  v.Number({"camera_horizontal_fov_deg", "deg", "Of each eye.", true}, {5, 150},
           r.camera_horizontal_fov_deg);
  v.Number({"pan_min_deg", "deg", "Each eye, rightmost.", true}, {-180, 0}, axes.pan_min_deg);
  v.Number({"pan_max_deg", "deg", "Each eye, leftmost.", true}, {0, 180}, axes.pan_max_deg);
  v.Number({"tilt_min_deg", "deg", "Each eye, highest.", true}, {-90, 0}, axes.tilt_min_deg);
  v.Number({"tilt_max_deg", "deg", "Each eye, lowest.", true}, {0, 90}, axes.tilt_max_deg);
  v.Number({"head_max_speed_deg_s", "deg/s", "Of each axis.", true}, kPositive,
           axes.max_speed_deg_s);
  v.Number({"head_max_acceleration_deg_s2", "deg/s^2", "Of each axis.", true}, kPositive,
           axes.max_acceleration_deg_s2);
  v.Number({"head_resolution_deg", "deg", "One encoder position.", true}, {0, 5},
           r.head_resolution_deg);
}

FieldTable TableOf(RobotDescription& robot, AxisKeys& axes) {
  return [&](FieldVisitor& v) {
    v.Text({"name", "", "Of the robot.", true}, {"", "", 80}, robot.name);
    v.Text({"mjcf_base_body", "", "Its root body in MuJoCo models.", true}, {"", "", 80},
           robot.mjcf_base_body);
    VisitBase(v, robot);
    VisitHead(v, robot, axes);
  };
}

void Complete(const AxisKeys& axes, RobotDescription& robot) {
  robot.head_geometry.X_BN = hardware::Pose::Identity();
  robot.head_geometry.X_BN.translation() = axes.neck_m;
  const auto limits = [&](double min_deg, double max_deg) {
    return hardware::AxisLimits{min_deg * kRadPerDeg, max_deg * kRadPerDeg,
                                axes.max_speed_deg_s * kRadPerDeg,
                                axes.max_acceleration_deg_s2 * kRadPerDeg};
  };
  using hardware::HeadAxis;
  for (HeadAxis axis : {HeadAxis::kLeftPan, HeadAxis::kRightPan}) {
    robot.head_limits[static_cast<std::size_t>(axis)] = limits(axes.pan_min_deg, axes.pan_max_deg);
  }
  for (HeadAxis axis : {HeadAxis::kLeftTilt, HeadAxis::kRightTilt}) {
    robot.head_limits[static_cast<std::size_t>(axis)] =
        limits(axes.tilt_min_deg, axes.tilt_max_deg);
  }
}

}  // namespace

RobotDescription LoadRobotDescription(const std::filesystem::path& path) {
  return ParseRobotDescription(ReadText(path), path.string());
}

RobotDescription ParseRobotDescription(const std::string& text, const std::string& name) {
  const YamlNode root = ParseYaml(text, name);
  RobotDescription robot;
  robot.file = name;
  AxisKeys axes;
  ParseReport report;
  ParseFields(root, TableOf(robot, axes), report);
  ThrowIfAny(std::move(report.diagnostics));
  Complete(axes, robot);
  return robot;
}

nlohmann::json RobotSchema() {
  RobotDescription robot;
  AxisKeys axes;
  nlohmann::json schema = FieldSchema(TableOf(robot, axes));
  schema["$schema"] = "http://json-schema.org/draft-07/schema#";
  schema["title"] = "Horopter robot";
  return schema;
}

}  // namespace horopter::scenarios
