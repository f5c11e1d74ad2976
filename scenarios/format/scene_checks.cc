// SPDX-License-Identifier: Apache-2.0
#include "scenarios/format/scene_checks.h"

#include <fmt/format.h>

#include "scenarios/format/metric_registry.h"
#include "scenarios/format/scene_names.h"
#include "scenarios/format/suggest.h"

namespace horopter::scenarios {
namespace {

/// Why a body cannot be placed so; "" when it can.
std::string WhyNotPlaced(const std::string& name, const BodyPlacement& placement,
                         const Scenario& scenario, const RobotDescription& robot,
                         const SceneContents& contents) {
  if (!contents.HasBody(name)) {
    return "scene '" + scenario.scene + "' has no such body" +
           DidYouMean(name, contents.static_bodies);
  }
  if (!contents.HasStaticBody(name)) {
    return "moves on joints, as a robot does; only what stands in the scene can be placed";
  }
  const Eigen::Vector3d& p_O = placement.position_m;
  if (p_O.head<2>().norm() < robot.radius_m && p_O.z() < robot.height_m) {
    return fmt::format(
        "position_m = [{:g}, {:g}, {:g}] is inside the robot at its start; place it "
        "more than {:g} m from there",
        p_O.x(), p_O.y(), p_O.z(), robot.radius_m);
  }
  return "";
}

void CheckBodies(const Scenario& scenario, const RobotDescription& robot,
                 const SceneContents& contents, const SourceMark& root, ParseReport& report) {
  for (const auto& [name, placement] : scenario.bodies) {
    const std::string path = "bodies." + name;
    const std::string why = WhyNotPlaced(name, placement, scenario, robot, contents);
    if (!why.empty()) report.Add(report.MarkOf(path, root), path + ": " + why);
  }
}

/// Scenes have the robot's start at W's origin, heading along x; what a seed turns it by is left
/// out, so that a goal at the very edge may still be beyond the wall.
void CheckGoals(const Scenario& scenario, const SceneContents& contents, ParseReport& report) {
  if (!contents.floor) return;
  for (std::size_t i = 0; i < scenario.steps.size(); ++i) {
    const auto* go = std::get_if<GotoStep>(&scenario.steps[i].action);
    if (go == nullptr || report.IsBroken(fmt::format("steps[{}]", i)) ||
        contents.floor->contains(go->goal_m)) {
      continue;
    }
    report.Add(
        scenario.steps[i].mark,
        fmt::format("goto ({:g}, {:g}) is off the floor of scene '{}': give x_m from {:g} to "
                    "{:g} and y_m from {:g} to {:g}",
                    go->goal_m.x(), go->goal_m.y(), scenario.scene, contents.floor->min().x(),
                    contents.floor->max().x(), contents.floor->min().y(),
                    contents.floor->max().y()));
  }
}

void CheckBoard(const Scenario& scenario, const SceneContents& contents, ParseReport& report) {
  if (contents.HasGeom("board")) return;
  for (const Expectation& expectation : scenario.expect) {
    const Metric* metric = FindMetric(expectation.metric);
    if (metric == nullptr || metric->needs != MetricNeeds::kBoard) continue;
    report.Add(expectation.mark, "'" + expectation.text + "' judges a board, but scene '" +
                                     scenario.scene +
                                     "' has no geom 'board': name a scene that has one or drop the "
                                     "expectation");
  }
}

void CheckCameras(const Scenario& scenario, const RobotDescription& robot,
                  const SceneContents& contents, const SourceMark& root, ParseReport& report) {
  for (const auto& [pair, cameras] : robot.cameras) {
    for (const std::string& camera : {cameras.left, cameras.right}) {
      if (contents.HasCamera(camera)) continue;
      report.Add(report.MarkOf("scene", root),
                 "scene '" + scenario.scene + "' has no camera '" + camera + "': robot '" +
                     scenario.robot + "' does not stand in it; name a scene of its own");
      return;
    }
  }
}

}  // namespace

void CheckAgainstScene(const Scenario& scenario, const RobotDescription& robot,
                       const std::filesystem::path& mjcf, const SourceMark& root,
                       ParseReport& report) {
  const auto contents = ReadSceneContents(mjcf);
  if (!contents) return;
  CheckBodies(scenario, robot, *contents, root, report);
  CheckGoals(scenario, *contents, report);
  CheckBoard(scenario, *contents, report);
  CheckCameras(scenario, robot, *contents, root, report);
}

}  // namespace horopter::scenarios
