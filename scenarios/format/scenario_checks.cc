// SPDX-License-Identifier: Apache-2.0
#include "scenarios/format/scenario_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <regex>

#include "control/kinematics/fixate.h"
#include "scenarios/format/metric_registry.h"
#include "scenarios/format/scene_checks.h"
#include "scenarios/format/scene_names.h"
#include "scenarios/format/scenes.h"
#include "scenarios/format/suggest.h"

namespace horopter::scenarios {
namespace {

constexpr double kDegPerRad = 180 / M_PI;

void CheckName(const Scenario& scenario, const SourceMark& root, ParseReport& report) {
  static const std::regex valid("[A-Za-z0-9][A-Za-z0-9_. -]{0,79}");
  if (report.marks.count("name") == 0 && !std::regex_match(scenario.name, valid)) {
    report.Add(root,
               "the file's name gives no scenario name: add `name:` with letters, digits, "
               "'_', '-' and '.'");
  }
}

/// Whether the scene is there.
bool CheckScene(const Scenario& scenario, const SourceMark& root,
                const std::filesystem::path& scenes_dir, ParseReport& report) {
  if (scenario.scene.empty()) return false;  // reported as missing
  if (std::filesystem::is_regular_file(scenes_dir / scenario.scene)) return true;
  report.Add(report.MarkOf("scene", root), "scene '" + scenario.scene + "' is not in " +
                                               scenes_dir.string() +
                                               DidYouMean(scenario.scene, SceneNames(scenes_dir)));
  return false;
}

std::optional<RobotDescription> FindRobot(const Scenario& scenario, const SourceMark& root,
                                          const std::filesystem::path& scenes_dir,
                                          ParseReport& report) {
  const auto names = RobotNames(scenes_dir);
  if (std::find(names.begin(), names.end(), scenario.robot) == names.end()) {
    report.Add(report.MarkOf("robot", root),
               "unknown robot '" + scenario.robot + "': no robot.yaml in " +
                   (scenes_dir / scenario.robot).string() + DidYouMean(scenario.robot, names));
    return std::nullopt;
  }
  try {
    return LoadRobotDescription(RobotFile(scenes_dir, scenario.robot));
  } catch (const ScenarioError& error) {
    for (const Diagnostic& d : error.diagnostics()) report.diagnostics.push_back(d);
  }
  return std::nullopt;
}

/// What no single field of the camera's profile shows.
void CheckProfile(const Scenario& scenario, const SourceMark& root, ParseReport& report) {
  for (const hardware::FieldError& error : scenario.camera.profile.Validate()) {
    report.Add(report.MarkOf(error.field, root), error.ToString());
  }
}

void CheckMedian(const Scenario& scenario, const SourceMark& root, ParseReport& report) {
  if (scenario.vision.median_px % 2 == 1) return;
  report.Add(report.MarkOf("vision.median_px", root),
             fmt::format("vision.median_px = {}: must be odd", scenario.vision.median_px));
}

/// Why the head, at the start, cannot look at a point of the base frame; "" when it can.
std::string WhyOutOfSight(const Eigen::Vector3d& p_B, const RobotDescription& robot) {
  const control::Fixation fixation =
      control::Fixate(robot.head_geometry, robot.head_limits, {}, p_B);
  switch (fixation.fault) {
    case control::FixationFault::kNone:
      return "";
    case control::FixationFault::kBehind:
      return fmt::format(
          "target is behind the robot: its head is at x = {:.3g} m; give it a larger "
          "x_m",
          robot.head_geometry.X_BN.translation().x());
    default:
      return "target is out of the head's reach: " + fixation.why;
  }
}

/// Why neck and eye together cannot turn by an angle; "" when they can.
std::string WhyBeyond(const char* what, double deg, const hardware::HeadLimits& limits,
                      hardware::HeadAxis neck_axis, hardware::HeadAxis eye_axis) {
  const auto& neck = limits[static_cast<std::size_t>(neck_axis)];
  const auto& eye = limits[static_cast<std::size_t>(eye_axis)];
  const double min_deg = (neck.min_rad + eye.min_rad) * kDegPerRad;
  const double max_deg = (neck.max_rad + eye.max_rad) * kDegPerRad;
  if (deg >= min_deg && deg <= max_deg) return "";
  return fmt::format("{} of {:.4g} deg is beyond the head's range, {:.1f} to {:.1f} deg", what, deg,
                     min_deg, max_deg);
}

std::string WhyNoSaccade(const SaccadeStep& step, const hardware::HeadLimits& limits) {
  using hardware::HeadAxis;
  // Converging axes: the left eye turns right by half the vergence, the right eye left.
  const double half_deg = step.vergence_deg / 2;
  for (const std::string& why :
       {WhyBeyond("a left tilt", step.tilt_deg, limits, HeadAxis::kNeckTilt, HeadAxis::kLeftTilt),
        WhyBeyond("a right tilt", step.tilt_deg, limits, HeadAxis::kNeckTilt, HeadAxis::kRightTilt),
        WhyBeyond("a left pan", step.pan_deg - half_deg, limits, HeadAxis::kNeckPan,
                  HeadAxis::kLeftPan),
        WhyBeyond("a right pan", step.pan_deg + half_deg, limits, HeadAxis::kNeckPan,
                  HeadAxis::kRightPan)}) {
    if (!why.empty()) return why;
  }
  return "";
}

/// How long a step is held at least [s]; 0 when it ends by itself.
double HeldFor(const StepAction& action) {
  if (const auto* step = std::get_if<FixateStep>(&action)) return step->hold_s;
  if (const auto* step = std::get_if<LookAtStep>(&action)) return step->hold_s;
  if (const auto* step = std::get_if<SaccadeStep>(&action)) return step->hold_s;
  if (const auto* step = std::get_if<WaitStep>(&action)) return step->duration_s;
  return 0;
}

void CheckDurations(const Scenario& scenario, ParseReport& report) {
  const double limit_s = scenario.time_limit_s;
  double held_s = 0;
  for (std::size_t i = 0; i < scenario.steps.size(); ++i) {
    if (report.IsBroken(fmt::format("steps[{}]", i))) continue;
    const Step& step = scenario.steps[i];
    const auto* go = std::get_if<GotoStep>(&step.action);
    if (go != nullptr && go->timeout_s > limit_s) {
      report.Add(step.mark, fmt::format("goto.timeout_s = {}: the run ends before, at time_limit_s "
                                        "= {}; raise that or lower this",
                                        go->timeout_s, limit_s));
    }
    const bool fitted = held_s < limit_s;
    held_s += HeldFor(step.action);
    if (fitted && held_s >= limit_s) {
      report.Add(step.mark, fmt::format("with this step the run lasts at least {} s, but ends at "
                                        "time_limit_s = {}; raise that or hold for less",
                                        held_s, limit_s));
    }
  }
}

/// Why a robot cannot do a step from its start; "" when it can.
std::string WhyNot(const StepAction& action, const RobotDescription& robot) {
  if (const auto* fixate = std::get_if<FixateStep>(&action)) {
    return WhyOutOfSight(fixate->target_m, robot);
  }
  if (const auto* look = std::get_if<LookAtStep>(&action)) {
    return WhyOutOfSight(look->target_m, robot);
  }
  if (const auto* saccade = std::get_if<SaccadeStep>(&action)) {
    return WhyNoSaccade(*saccade, robot.head_limits);
  }
  return "";
}

void CheckRoom(const Scenario& scenario, const SourceMark& root, ParseReport& report) {
  if (!scenario.room) return;
  const RoomSpec& room = *scenario.room;
  if (room.max_obstacles < room.min_obstacles) {
    report.Add(report.MarkOf("room.max_obstacles", report.MarkOf("room", root)),
               fmt::format("room.max_obstacles = {}: must be at least room.min_obstacles = {}",
                           room.max_obstacles, room.min_obstacles));
  }
  const bool goes = std::any_of(scenario.steps.begin(), scenario.steps.end(), [](const Step& step) {
    return std::holds_alternative<GotoStep>(step.action);
  });
  if (!goes && !scenario.steps.empty()) {
    report.Add(report.MarkOf("room", root),
               "room: its path leads to the goals of goto steps, and there is none: add one");
  }
}

void CheckFaultTimes(const Scenario& scenario, ParseReport& report) {
  for (const FaultSpec& fault : scenario.faults) {
    if (fault.until_s > fault.from_s) continue;
    report.Add(fault.mark, fmt::format("until_s = {}: must be later than from_s = {}",
                                       fault.until_s, fault.from_s));
  }
}

/// Axes that a fault is about, by name.
std::vector<std::string> AxesOf(const FaultKind& kind) {
  if (const auto* fault = std::get_if<BacklashFault>(&kind)) return {fault->axis};
  if (const auto* fault = std::get_if<EncoderBiasFault>(&kind)) return {fault->axis};
  if (const auto* fault = std::get_if<EncoderNoiseFault>(&kind)) return {fault->axis};
  if (const auto* fault = std::get_if<StuckAxisFault>(&kind)) return {fault->axis};
  std::vector<std::string> axes;
  if (const auto* fault = std::get_if<ZeroOffFault>(&kind)) {
    if (fault->pan_deg != 0) axes.push_back(fault->eye + "_pan");
    if (fault->tilt_deg != 0) axes.push_back(fault->eye + "_tilt");
  }
  return axes;
}

void CheckFaults(const Scenario& scenario, const RobotDescription& robot, ParseReport& report) {
  for (std::size_t i = 0; i < scenario.faults.size(); ++i) {
    if (report.IsBroken(fmt::format("faults[{}]", i))) continue;
    for (const std::string& axis : AxesOf(scenario.faults[i].kind)) {
      const auto& names = hardware::kHeadAxisNames;
      const auto index = std::find(names.begin(), names.end(), axis) - names.begin();
      if (robot.head_limits[index].exists()) continue;
      report.Add(scenario.faults[i].mark, "robot '" + robot.name + "' has no axis '" + axis + "'");
    }
  }
}

void CheckSteps(const Scenario& scenario, const RobotDescription& robot, ParseReport& report) {
  // Once the robot has driven, what is behind its start may be before it.
  bool at_start = true;
  for (std::size_t i = 0; i < scenario.steps.size(); ++i) {
    const Step& step = scenario.steps[i];
    if (report.IsBroken(fmt::format("steps[{}]", i))) continue;
    if (std::holds_alternative<GotoStep>(step.action)) at_start = false;
    if (!at_start) continue;
    const std::string why = WhyNot(step.action, robot);
    if (!why.empty()) report.Add(step.mark, why);
  }
}

template <typename Action>
bool HasStep(const Scenario& scenario) {
  return std::any_of(scenario.steps.begin(), scenario.steps.end(),
                     [](const Step& step) { return std::holds_alternative<Action>(step.action); });
}

void CheckExpectations(const Scenario& scenario, ParseReport& report) {
  for (const Expectation& expectation : scenario.expect) {
    const Metric* metric = FindMetric(expectation.metric);
    if (metric == nullptr) continue;
    if (metric->needs == MetricNeeds::kGoal && !HasStep<GotoStep>(scenario)) {
      report.Add(expectation.mark, "'" + expectation.text +
                                       "' judges a goal, but no step is a "
                                       "goto: add one or drop the expectation");
    }
    const bool fixates =
        metric->needs == MetricNeeds::kFixation || metric->needs == MetricNeeds::kBoard;
    if (fixates && !HasStep<FixateStep>(scenario)) {
      report.Add(expectation.mark, "'" + expectation.text +
                                       "' judges a fixation, but no step is "
                                       "a fixate: add one or drop the expectation");
    }
  }
}

}  // namespace

std::optional<RobotDescription> CheckScenario(const Scenario& scenario, const SourceMark& root,
                                              const std::filesystem::path& scenes_dir,
                                              ParseReport& report) {
  CheckName(scenario, root, report);
  CheckMedian(scenario, root, report);
  CheckProfile(scenario, root, report);
  CheckDurations(scenario, report);
  CheckRoom(scenario, root, report);
  CheckFaultTimes(scenario, report);
  std::optional<RobotDescription> robot;
  if (!scenes_dir.empty()) {
    const bool found = CheckScene(scenario, root, scenes_dir, report);
    robot = FindRobot(scenario, root, scenes_dir, report);
    if (robot && !robot->wheels) {
      report.Add(report.MarkOf("robot", root),
                 "robot '" + scenario.robot +
                     "' plays no scenarios yet: they need one with wheels; `horopter render` shows "
                     "its scenes");
    }
    if (found && robot) {
      CheckAgainstScene(scenario, *robot, scenes_dir / scenario.scene, root, report);
    }
  }
  if (robot) CheckSteps(scenario, *robot, report);
  if (robot) CheckFaults(scenario, *robot, report);
  // A list of which an element did not parse says nothing about what is missing in it.
  if (report.broken.empty() && !scenario.steps.empty()) CheckExpectations(scenario, report);
  return robot;
}

}  // namespace horopter::scenarios
