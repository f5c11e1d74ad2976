// SPDX-License-Identifier: Apache-2.0
#include "scenarios/render/motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "hardware/types/config_error.h"
#include "scenarios/format/field_parser.h"
#include "scenarios/format/read_text.h"
#include "sim/nao/planar_gait.h"

namespace horopter::scenarios {
namespace {

constexpr double kRadians = M_PI / 180;
constexpr double kLongest_s = 600;
constexpr double kFarthest_m = 20;
constexpr Range kAngle{-180, 180};
constexpr Range kSpeed{-5, 5};
constexpr Range kTurnRate{-720, 720};

/// A number that may be left out, and then stays so.
void VisitOptional(FieldVisitor& v, const FieldSpec& spec, std::optional<double>& value) {
  double number = value.value_or(std::numeric_limits<double>::quiet_NaN());
  v.Number(spec, kAngle, number);
  if (!std::isnan(number)) value = number;
}

void Visit(FieldVisitor& v, SaccadeCommand& c) {
  VisitOptional(v, {SaccadeCommand::kGazeKeys[0], "deg", "Pan, positive left."}, c.gaze_deg[0]);
  VisitOptional(v, {SaccadeCommand::kGazeKeys[1], "deg", "Tilt, positive down."}, c.gaze_deg[1]);
  VisitOptional(
      v, {SaccadeCommand::kGazeKeys[2], "deg", "Between the optical axes, positive converging."},
      c.gaze_deg[2]);
  for (std::size_t i = 0; i < c.axis_deg.size(); ++i) {
    VisitOptional(v,
                  {std::string(hardware::kHeadAxisNames[i]) + "_deg", "deg",
                   "An axis, in place of a gaze; those left out stay where they are told to be."},
                  c.axis_deg[i]);
  }
}

void Visit(FieldVisitor& v, WalkToCommand& c) {
  constexpr Range kPlace{-kFarthest_m, kFarthest_m};
  v.Number({"x_m", "m", "Forward of where the robot stands then."}, kPlace, c.x_m);
  v.Number({"y_m", "m", "To its left."}, kPlace, c.y_m);
  v.Number({"turn_deg", "deg", "How far it turns left."}, kAngle, c.turn_deg);
}

void Visit(FieldVisitor& v, WalkCommand& c) {
  v.Number({"forward_m_s", "m/s", "Forward."}, kSpeed, c.forward_m_s);
  v.Number({"left_m_s", "m/s", "To the left."}, kSpeed, c.left_m_s);
  v.Number({"turn_deg_s", "deg/s", "Turning left."}, kTurnRate, c.turn_deg_s);
}

void Visit(FieldVisitor& v, DriveCommand& c) {
  v.Number({"forward_m_s", "m/s", "Forward."}, kSpeed, c.forward_m_s);
  v.Number({"turn_deg_s", "deg/s", "Turning left."}, kTurnRate, c.turn_deg_s);
}

/// The alternative that makes a command a `Kind`, keeping what it has when it is one.
template <typename Kind>
Alternative CommandKind(const char* key, const char* doc, MotionCommand& command) {
  return {{key, "", doc}, std::holds_alternative<Kind>(command.what), [&command](FieldVisitor& v) {
            if (!std::holds_alternative<Kind>(command.what)) command.what = Kind{};
            v.Number({"at_s", "s", "When it is given."}, {0, kLongest_s}, command.at_s);
            Visit(v, std::get<Kind>(command.what));
          }};
}

AlternativeList CommandList(std::vector<MotionCommand>& commands) {
  return {{"commands", "", "What the robot is told, and when."},
          commands.size(),
          [&commands](std::size_t index, const SourceMark&) {
            if (index == commands.size()) commands.emplace_back();
            MotionCommand& c = commands[index];
            return std::vector<Alternative>{
                CommandKind<SaccadeCommand>("saccade", "Turn the head.", c),
                CommandKind<WalkToCommand>("walk_to", "Walk to a pose.", c),
                CommandKind<WalkCommand>("walk", "Walk at a velocity.", c),
                CommandKind<DriveCommand>("drive", "Drive at a speed.", c)};
          }};
}

bool Any(std::span<const std::optional<double>> angles) {
  return std::any_of(angles.begin(), angles.end(), [](const auto& a) { return a.has_value(); });
}

/// The gaze that axes stand for: of the neck where it pans, otherwise of both eyes' middle, as
/// control::Turn() has it the other way round.
Gaze GazeOf(const hardware::HeadAngles& head, const hardware::HeadLimits& limits) {
  const bool by_neck = limits[static_cast<std::size_t>(hardware::HeadAxis::kNeckPan)].exists();
  const double pan = by_neck ? head.neck.pan_rad : (head.left.pan_rad + head.right.pan_rad) / 2;
  const double tilt = by_neck ? head.neck.tilt_rad : (head.left.tilt_rad + head.right.tilt_rad) / 2;
  const double vergence = head.right.pan_rad - head.left.pan_rad;
  // Rounded, so that an axis at its limit is not beyond it by its last bits.
  const auto deg = [](double rad) { return std::round(rad / kRadians * 1e9) / 1e9; };
  return {deg(pan), deg(tilt), deg(vergence)};
}

/// Holds one command against the robot.
class Check {
 public:
  /// @param head where it is told to be before and, if it can be, after the command
  Check(const RobotDescription& robot, hardware::HeadAngles& head, std::string where)
      : robot_(robot), head_(head), where_(std::move(where)) {}

  void operator()(const SaccadeCommand& c) const {
    head_ = AnglesOf(c, head_, HeadReach(robot_), where_ + ": saccade: ");
  }

  void operator()(const WalkToCommand& c) const {
    RequireLegs("walk_to");
    RequireWithin("walk_to: x_m", c.x_m, kFarthest_m);
    RequireWithin("walk_to: y_m", c.y_m, kFarthest_m);
    RequireWithin("walk_to: turn_deg", c.turn_deg, kAngle.max);
  }

  void operator()(const WalkCommand& c) const {
    RequireLegs("walk");
    const hardware::WalkVelocity most = sim::NaoGaitConfig{}.MaxVelocity();
    RequireWithin("walk: forward_m_s", c.forward_m_s, most.forward_m_s);
    RequireWithin("walk: left_m_s", c.left_m_s, most.left_m_s);
    RequireWithin("walk: turn_deg_s", c.turn_deg_s, most.turn_rad_s / kRadians);
  }

  void operator()(const DriveCommand& c) const {
    if (!robot_.wheels) Refuse("drive", robot_.name, "has no wheels: robot koala has");
    const hardware::BaseProperties& base = robot_.wheels->properties;
    const double wheel =
        std::abs(c.forward_m_s) + std::abs(c.turn_deg_s) * kRadians * base.effective_track_m / 2;
    if (wheel <= base.max_wheel_speed_m_s) return;
    Refuse("drive", fmt::format("{:g} m/s, {:g} deg/s", c.forward_m_s, c.turn_deg_s),
           fmt::format("asks a wheel for {:.3g} m/s: it turns at {:g} m/s at most", wheel,
                       base.max_wheel_speed_m_s));
  }

 private:
  [[noreturn]] void Refuse(const std::string& what, const std::string& value,
                           const std::string& why) const {
    throw hardware::ConfigError({{where_ + ": " + what, value, why}});
  }
  void RequireLegs(const char* what) const {
    if (robot_.name != "nao") Refuse(what, robot_.name, "cannot walk: robot nao can");
  }
  void RequireWithin(const char* what, double value, double most) const {
    if (std::abs(value) <= most) return;
    Refuse(what, fmt::format("{:g}", value),
           fmt::format("must be from {0:.3g} to {1:.3g}", -most, most));
  }

  const RobotDescription& robot_;
  hardware::HeadAngles& head_;
  std::string where_;
};

}  // namespace

void Visit(FieldVisitor& v, Motion& motion) {
  v.Number({"duration_s", "s", "How long the cameras run."}, {0, kLongest_s, true},
           motion.duration_s);
  v.Alternatives(CommandList(motion.commands));
}

Motion ReadMotionFile(const std::filesystem::path& path) {
  Motion motion;
  ParseReport report;
  ParseFields(
      ParseYaml(ReadText(path), path.string()), [&motion](FieldVisitor& v) { Visit(v, motion); },
      report);
  ThrowIfAny(std::move(report.diagnostics));
  return motion;
}

std::vector<MotionCommand> InOrder(const Motion& motion) {
  std::vector<MotionCommand> commands = motion.commands;
  std::stable_sort(commands.begin(), commands.end(),
                   [](const auto& a, const auto& b) { return a.at_s < b.at_s; });
  return commands;
}

hardware::HeadAngles AnglesOf(const SaccadeCommand& saccade, const hardware::HeadAngles& present,
                              const HeadReach& reach, const std::string& where) {
  if (Any(saccade.axis_deg) && Any(saccade.gaze_deg)) {
    throw hardware::ConfigError({{where + "gaze", "beside axes",
                                  "would turn the axes that others name: give one or the other"}});
  }
  if (Any(saccade.gaze_deg)) {
    const Gaze now = GazeOf(present, reach.limits());
    return reach.AnglesOf(
        {saccade.gaze_deg[0].value_or(now.pan_deg), saccade.gaze_deg[1].value_or(now.tilt_deg),
         saccade.gaze_deg[2].value_or(now.vergence_deg)},
        where);
  }
  hardware::HeadAxisArray angles = hardware::ToArray(present);
  for (std::size_t i = 0; i < angles.size(); ++i) {
    if (saccade.axis_deg[i]) angles[i] = *saccade.axis_deg[i] * kRadians;
  }
  const hardware::HeadAngles head = hardware::FromArray(angles);
  reach.Require(head, where);
  return head;
}

void CheckMotion(const Motion& motion, const RobotDescription& robot,
                 const hardware::HeadAngles& start) {
  std::vector<hardware::FieldError> errors;
  if (!(motion.duration_s > 0 && motion.duration_s <= kLongest_s)) {
    errors.push_back({"motion: duration", fmt::format("{:g} s", motion.duration_s),
                      fmt::format("must be above 0 and at most {:g} s", kLongest_s)});
  }
  hardware::HeadAngles head = start;
  for (const MotionCommand& command : InOrder(motion)) {
    try {
      std::visit(Check(robot, head, fmt::format("motion: at {:g} s", command.at_s)), command.what);
    } catch (const hardware::ConfigError& error) {
      errors.insert(errors.end(), error.errors().begin(), error.errors().end());
    }
    if (command.at_s < motion.duration_s) continue;
    errors.push_back(
        {"motion: command at", fmt::format("{:g} s", command.at_s),
         fmt::format("comes too late, the motion ends at {:g} s: make it longer with duration_s "
                     "or --duration",
                     motion.duration_s)});
  }
  hardware::ThrowIfAny(std::move(errors));
}

}  // namespace horopter::scenarios
