// SPDX-License-Identifier: Apache-2.0
#include "scenarios/format/scenario_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <regex>

#include "control/kinematics/fixate.h"
#include "scenarios/format/metric_registry.h"
#include "scenarios/format/robot_description.h"
#include "scenarios/format/scenes.h"
#include "scenarios/format/suggest.h"

namespace horopter::scenarios {
namespace {

constexpr double kDegPerRad = 180 / M_PI;

/// A field's place, or the document's when the default stands.
SourceMark MarkOf(const ParseReport& report, const std::string& path, const SourceMark& root) {
  const auto found = report.marks.find(path);
  return found == report.marks.end() ? root : found->second;
}

void CheckName(const Scenario& scenario, const SourceMark& root, ParseReport& report) {
  static const std::regex valid("[A-Za-z0-9][A-Za-z0-9_. -]{0,79}");
  if (report.marks.count("name") == 0 && !std::regex_match(scenario.name, valid)) {
    report.Add(root,
               "the file's name gives no scenario name: add `name:` with letters, digits, "
               "'_', '-' and '.'");
  }
}

void CheckScene(const Scenario& scenario, const SourceMark& root,
                const std::filesystem::path& scenes_dir, ParseReport& report) {
  if (scenario.scene.empty() || std::filesystem::is_regular_file(scenes_dir / scenario.scene)) {
    return;
  }
  report.Add(MarkOf(report, "scene", root), "scene '" + scenario.scene + "' is not in " +
                                                scenes_dir.string() +
                                                DidYouMean(scenario.scene, SceneNames(scenes_dir)));
}

std::optional<RobotDescription> FindRobot(const Scenario& scenario, const SourceMark& root,
                                          const std::filesystem::path& scenes_dir,
                                          ParseReport& report) {
  const auto names = RobotNames(scenes_dir);
  if (std::find(names.begin(), names.end(), scenario.robot) == names.end()) {
    report.Add(MarkOf(report, "robot", root),
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

void CheckMedian(const Scenario& scenario, const SourceMark& root, ParseReport& report) {
  if (scenario.vision.median_px % 2 == 1) return;
  report.Add(MarkOf(report, "vision.median_px", root),
             fmt::format("vision.median_px = {}: must be odd", scenario.vision.median_px));
}

/// How far one axis after the other can turn an eye: neck and eye together [rad].
struct Reach {
  double min_rad = 0;
  double max_rad = 0;
};

Reach PanReach(const hardware::HeadLimits& limits) {
  using hardware::HeadAxis;
  const auto of = [&](HeadAxis axis) { return limits[static_cast<std::size_t>(axis)]; };
  const auto neck = of(HeadAxis::kNeckPan);
  const auto left = of(HeadAxis::kLeftPan);
  const auto right = of(HeadAxis::kRightPan);
  return {neck.min_rad + std::min(left.min_rad, right.min_rad),
          neck.max_rad + std::max(left.max_rad, right.max_rad)};
}

Reach TiltReach(const hardware::HeadLimits& limits) {
  using hardware::HeadAxis;
  const auto of = [&](HeadAxis axis) { return limits[static_cast<std::size_t>(axis)]; };
  const auto neck = of(HeadAxis::kNeckTilt);
  const auto left = of(HeadAxis::kLeftTilt);
  const auto right = of(HeadAxis::kRightTilt);
  return {neck.min_rad + std::min(left.min_rad, right.min_rad),
          neck.max_rad + std::max(left.max_rad, right.max_rad)};
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

std::string WhyNoSaccade(const SaccadeStep& step, const RobotDescription& robot) {
  const auto outside = [](const char* axis, double deg, const Reach& reach) -> std::string {
    if (deg >= reach.min_rad * kDegPerRad && deg <= reach.max_rad * kDegPerRad) return "";
    return fmt::format("{} of {:.4g} deg is beyond the head's range, {:.1f} to {:.1f} deg", axis,
                       deg, reach.min_rad * kDegPerRad, reach.max_rad * kDegPerRad);
  };
  const std::string tilt = outside("a tilt", step.tilt_deg, TiltReach(robot.head_limits));
  if (!tilt.empty()) return tilt;
  const Reach pan = PanReach(robot.head_limits);
  // Converging axes: the left eye turns right by half the vergence, the right eye left.
  const std::string left = outside("a left pan", step.pan_deg - step.vergence_deg / 2, pan);
  return !left.empty() ? left : outside("a right pan", step.pan_deg + step.vergence_deg / 2, pan);
}

void CheckSteps(const Scenario& scenario, const std::optional<RobotDescription>& robot,
                ParseReport& report) {
  // Once the robot has driven, what is behind its start may be before it.
  bool at_start = true;
  for (std::size_t i = 0; i < scenario.steps.size(); ++i) {
    const Step& step = scenario.steps[i];
    if (report.broken.count(fmt::format("steps[{}]", i)) > 0) continue;
    const auto* go = std::get_if<GotoStep>(&step.action);
    if (go != nullptr) at_start = false;
    if (go != nullptr && go->timeout_s > scenario.time_limit_s) {
      report.Add(step.mark, fmt::format("goto.timeout_s = {}: the run ends before, at time_limit_s "
                                        "= {}; raise that or lower this",
                                        go->timeout_s, scenario.time_limit_s));
    }
    if (!robot || !at_start) continue;
    std::string why;
    if (const auto* fixate = std::get_if<FixateStep>(&step.action)) {
      why = WhyOutOfSight(fixate->target_m, *robot);
    } else if (const auto* look = std::get_if<LookAtStep>(&step.action)) {
      why = WhyOutOfSight(look->target_m, *robot);
    } else if (const auto* saccade = std::get_if<SaccadeStep>(&step.action)) {
      why = WhyNoSaccade(*saccade, *robot);
    }
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
    if (metric->needs == MetricNeeds::kFixation && !HasStep<FixateStep>(scenario)) {
      report.Add(expectation.mark, "'" + expectation.text +
                                       "' judges a fixation, but no step is "
                                       "a fixate: add one or drop the expectation");
    }
  }
}

}  // namespace

void CheckScenario(const Scenario& scenario, const SourceMark& root,
                   const std::filesystem::path& scenes_dir, ParseReport& report) {
  CheckName(scenario, root, report);
  CheckMedian(scenario, root, report);
  std::optional<RobotDescription> robot;
  if (!scenes_dir.empty()) {
    CheckScene(scenario, root, scenes_dir, report);
    robot = FindRobot(scenario, root, scenes_dir, report);
  }
  CheckSteps(scenario, robot, report);
  // A list of which an element did not parse says nothing about what is missing in it.
  if (report.broken.empty() && !scenario.steps.empty()) CheckExpectations(scenario, report);
}

}  // namespace horopter::scenarios
