// SPDX-License-Identifier: Apache-2.0
#include "scenarios/render/request_checks.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <type_traits>
#include <utility>
#include <variant>

#include "hardware/types/config_error.h"
#include "scenarios/format/fault_fields.h"
#include "scenarios/format/scene_names.h"
#include "scenarios/format/scenes.h"
#include "scenarios/format/suggest.h"
#include "sim/render/gl_context.h"
#include "sim/tabletop/arrange_tabletop.h"

namespace horopter::scenarios {
namespace {

namespace fs = std::filesystem;
using hardware::Eye;

const std::string kRobot = "base";  ///< the body that every scene has the robot as

[[noreturn]] void Refuse(const std::string& option, const std::string& value,
                         const std::string& why) {
  throw hardware::ConfigError({{option, value, why}});
}

bool Has(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool IsScene(const SceneContents& contents) {
  return contents.HasGeom("floor") && contents.HasBody(kRobot);
}

std::vector<std::string> BackgroundsOf(const SceneContents& contents) {
  std::vector<std::string> names;
  for (const std::string& body : contents.bodies) {
    if (!body.starts_with(sim::kBackgroundPrefix)) continue;
    names.push_back(body.substr(sim::kBackgroundPrefix.size()));
  }
  return names;
}

/// Whether there is a table to put objects on, before one of several backgrounds: a room may have a
/// table as well.
bool HasTable(const SceneContents& contents) {
  return contents.HasGeom("table_top") && !BackgroundsOf(contents).empty();
}

/// Cameras that are none of the robot's own.
std::vector<std::string> ViewsIn(const SceneContents& contents, const RobotDescription& robot) {
  std::vector<std::string> views;
  for (const std::string& camera : contents.cameras) {
    const bool own = std::any_of(robot.cameras.begin(), robot.cameras.end(), [&](const auto& pair) {
      return pair.second.left == camera || pair.second.right == camera;
    });
    if (!own) views.push_back(camera);
  }
  return views;
}

std::vector<std::string> NamesOf(const std::vector<SceneListing>& scenes, bool with_table) {
  std::vector<std::string> names;
  for (const SceneListing& scene : scenes) {
    if (!with_table || !scene.backgrounds.empty()) names.push_back(scene.name);
  }
  return names;
}

SceneContents ContentsOf(const RenderRequest& request) {
  const fs::path file = ScenesDir() / request.scene;
  const auto names = [] { return NamesOf(ListScenes(), false); };
  if (!fs::is_regular_file(file)) {
    Refuse("SCENE", request.scene,
           "is not in " + ScenesDir().string() + DidYouMean(request.scene, names()));
  }
  const auto contents = ReadSceneContents(file);
  if (!contents) Refuse("SCENE", request.scene, "or what it includes is no XML");
  if (!IsScene(*contents)) {
    Refuse("SCENE", request.scene,
           fmt::format("is only a part that scenes include: name one of {}",
                       fmt::join(names(), ", ")));
  }
  return *contents;
}

void CheckTable(const RenderRequest& request, const SceneContents& contents) {
  if (!request.table) return;
  if (!HasTable(contents)) {
    Refuse("SCENE", request.scene,
           fmt::format("has no table: drop --clutter, --occluded, --background, --brightness and "
                       "--colour-temperature, or name {}",
                       fmt::join(NamesOf(ListScenes(), true), ", ")));
  }
  const auto backgrounds = BackgroundsOf(contents);
  const std::string& asked = request.table->background;
  if (asked.empty() || Has(backgrounds, asked)) return;
  Refuse("--background", asked, "is not in this scene" + DidYouMean(asked, backgrounds));
}

void CheckCameras(const RenderRequest& request, const RobotDescription& robot,
                  const SceneContents& contents) {
  for (const std::string& name : PairNames(request, robot)) {
    const CameraPairDescription& pair = robot.Cameras(name);
    if (contents.HasCamera(pair.left) && contents.HasCamera(pair.right)) continue;
    Refuse("--robot", request.robot,
           fmt::format("does not stand in {}, which has no camera '{}'", request.scene, pair.left));
  }
  if (request.camera.horizontal_fov_deg != kRobotsOwn && PairNames(request, robot).size() > 1) {
    Refuse("--camera-file", "horizontal_fov_deg",
           "would make all pairs alike: choose one with --camera, of " +
               fmt::format("{}", fmt::join(PairNames(request, robot), ", ")));
  }
  const bool width = request.camera.width != RenderRequest::kNative;
  const bool height = request.camera.height != RenderRequest::kNative;
  if (width != height) {
    Refuse("--camera-file", width ? "width" : "height", "needs the other: give both, or neither");
  }
}

void CheckBetween(const RenderRequest& request, const RobotDescription& robot) {
  std::vector<std::string> stems;
  for (const std::string& pair : PairNames(request, robot)) {
    for (const Eye eye : hardware::kBothEyes) {
      stems.push_back(CameraStem(request, robot, pair, eye));
    }
  }
  for (const std::string& text : request.between) {
    if (!request.truth) Refuse("--truth-between", text, "needs --truth");
    const std::size_t colon = text.find(':');
    const std::string from = text.substr(0, colon);
    const std::string to = colon == std::string::npos ? "" : text.substr(colon + 1);
    if (colon != std::string::npos && from != to && Has(stems, from) && Has(stems, to)) continue;
    Refuse("--truth-between", text,
           fmt::format("must be CAMERA:CAMERA, two of {}", fmt::join(stems, ", ")));
  }
}

void RequireDistinct(const std::string& option, std::vector<std::string> names) {
  std::sort(names.begin(), names.end());
  const auto twice = std::adjacent_find(names.begin(), names.end());
  if (twice != names.end()) Refuse(option, *twice, "stands twice: give it once");
}

/// Bodies that the poses name, by their columns.
void CheckBodies(const RenderRequest& request, const SceneContents& contents) {
  for (const std::string& column : request.poses.columns) {
    const std::size_t dot = column.rfind('.');
    if (dot == std::string::npos) continue;
    const std::string body = column.substr(0, dot);
    const std::string where =
        request.poses.file.empty() ? "--body" : request.poses.file + ":1: column";
    if (body == kRobot) Refuse(where, body, "is the robot, which stays: move what it looks at");
    if (contents.HasBody(body)) continue;
    Refuse(where, body, "is no body of this scene" + DidYouMean(body, contents.bodies));
  }
}

/// Two pairs may be the same cameras with other lenses: a robot has one of them on at a time.
bool SharesCameras(const CameraPairDescription& a, const CameraPairDescription& b) {
  return a.left == b.left || a.right == b.right;
}

bool Turns(const RobotDescription& robot, const std::string& axis) {
  const auto& names = hardware::kHeadAxisNames;
  const auto found = std::find(names.begin(), names.end(), axis);
  return found != names.end() &&
         robot.head_limits[static_cast<std::size_t>(found - names.begin())].exists();
}

/// The axis of the head that a fault needs and the robot lacks, "" when there is none.
std::string LackingAxis(const FaultSpec& fault, const RobotDescription& robot) {
  return std::visit(
      [&robot](const auto& kind) -> std::string {
        if constexpr (requires { kind.axis; }) {
          if (!Turns(robot, kind.axis)) return kind.axis;
        } else if constexpr (std::is_same_v<std::decay_t<decltype(kind)>, ZeroOffFault>) {
          if (kind.pan_deg != 0 && !Turns(robot, kind.eye + "_pan")) return kind.eye + "_pan";
          if (kind.tilt_deg != 0 && !Turns(robot, kind.eye + "_tilt")) return kind.eye + "_tilt";
        }
        return "";
      },
      fault.kind);
}

void CheckFaults(const RenderRequest& request, const RobotDescription& robot) {
  if (request.faults.empty()) return;
  if (!request.motion) {
    Refuse("--faults", fmt::format("{} faults", request.faults.size()),
           "are a motion's: give --motion, --saccade, --walk, --drive or --duration as well");
  }
  std::vector<hardware::FieldError> errors;
  for (const FaultSpec& fault : request.faults) {
    const std::string axis = LackingAxis(fault, robot);
    if (axis.empty()) continue;
    errors.push_back({"--faults", DescribeFault(fault),
                      fmt::format("robot {} has no axis {}; a camera that sits crooked is a "
                                  "misaligned_eye",
                                  robot.name, axis)});
  }
  hardware::ThrowIfAny(std::move(errors));
}

void CheckFilm(const RenderRequest& request, const RobotDescription& robot) {
  if (request.poses.rows.size() != 1) {
    Refuse("motion", fmt::format("{} poses", request.poses.rows.size()),
           "begins at one pose: give one");
  }
  CheckMotion(*request.motion, robot, ViewsOf(request.poses, HeadReach(robot)).front().head);
  if (request.camera.profile.timing.rate_hz <= 0) {
    Refuse("motion", "camera.timing.rate_hz = 0", "needs cameras with a rate: give one");
  }
  const auto names = PairNames(request, robot);
  for (std::size_t i = 1; i < names.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (!SharesCameras(robot.Cameras(names[i]), robot.Cameras(names[j]))) continue;
      Refuse("--camera", names[i],
             "are the same cameras as " + names[j] + " with other lenses: film with one of them");
    }
  }
}

}  // namespace

std::vector<SceneListing> ListScenes() {
  const fs::path folder = ScenesDir();
  std::vector<SceneListing> scenes;
  for (const std::string& name : SceneNames(folder)) {
    const auto contents = ReadSceneContents(folder / name);
    if (!contents || !IsScene(*contents)) continue;
    SceneListing scene{name, contents->cameras, {}};
    const fs::path robot = RobotFile(folder, fs::path(name).begin()->string());
    if (fs::is_regular_file(robot)) scene.views = ViewsIn(*contents, LoadRobotDescription(robot));
    if (HasTable(*contents)) scene.backgrounds = BackgroundsOf(*contents);
    scenes.push_back(std::move(scene));
  }
  return scenes;
}

RobotDescription RobotOf(const RenderRequest& request) {
  const fs::path scenes = ScenesDir();
  const fs::path file = RobotFile(scenes, request.robot);
  if (fs::is_regular_file(file)) return LoadRobotDescription(file);
  Refuse("--robot", request.robot,
         "has no robot.yaml in " + scenes.string() + DidYouMean(request.robot, RobotNames(scenes)));
}

void CheckScene(const RenderRequest& request) { ContentsOf(request); }

void CheckRequest(const RenderRequest& request, const RobotDescription& robot) {
  const SceneContents contents = ContentsOf(request);
  const std::vector<std::string_view> backends = sim::GlBackends();
  if (std::find(backends.begin(), backends.end(), request.gl) == backends.end()) {
    Refuse("--gl", request.gl, fmt::format("must be one of: {}", fmt::join(backends, ", ")));
  }
  RequireDistinct("--camera", request.pairs);
  RequireDistinct("--view", request.views);
  RequireDistinct("--truth-between", request.between);
  CheckTable(request, contents);
  CheckCameras(request, robot, contents);
  const auto views = ViewsIn(contents, robot);
  for (const std::string& view : request.views) {
    if (!Has(views, view)) Refuse("--view", view, "is not in this scene" + DidYouMean(view, views));
  }
  CheckBetween(request, robot);
  CheckBodies(request, contents);
  CheckFaults(request, robot);
  if (request.motion) CheckFilm(request, robot);
}

std::vector<std::string> PairNames(const RenderRequest& request, const RobotDescription& robot) {
  if (!request.pairs.empty()) return request.pairs;
  std::vector<std::string> names;
  for (const auto& [name, pair] : robot.cameras) {
    const bool taken = std::any_of(names.begin(), names.end(), [&](const std::string& other) {
      return SharesCameras(pair, robot.Cameras(other));
    });
    if (!request.motion || !taken) names.push_back(name);
  }
  return names;
}

std::string CameraStem(const RenderRequest& request, const RobotDescription& robot,
                       const std::string& pair, Eye eye) {
  const bool only = PairNames(request, robot).size() == 1;
  return (only ? "" : pair + "_") + ToString(eye);
}

}  // namespace horopter::scenarios
