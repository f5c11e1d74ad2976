// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hardware/types/config_error.h"
#include "scenarios/cli/commands.h"
#include "scenarios/dataset/png16.h"
#include "scenarios/format/read_text.h"
#include "scenarios/format/scenes.h"
#include "scenarios/format/suggest.h"
#include "scenarios/render/contact_sheet.h"
#include "scenarios/render/gaze_list.h"
#include "scenarios/render/render_dataset.h"
#include "scenarios/runner/exit_code.h"
#include "scenarios/runner/run_process.h"
#include "scenarios/runner/versions.h"

namespace horopter::scenarios {
namespace {

namespace fs = std::filesystem;

struct RenderArguments {
  std::string scene;
  std::string robot;
  std::vector<std::string> cameras;
  std::string pan, tilt, vergence;  ///< "A" or "A:B"; "" = not given
  std::string poses;
  int random = 0;
  std::optional<std::uint64_t> seed;
  std::string size;
  std::string profile = "ideal";
  std::string gl = "osmesa";
  bool truth = false;
  bool png16 = false;
  bool supersample = false;
  std::vector<std::string> views;
  std::string sheet;
  std::string out;
  std::string obstacles;
  bool blocked = false;
  int clutter = 0;
  std::optional<double> occluded;
  std::string background;
  std::optional<double> brightness;
  std::optional<double> colour_temperature;
};

[[noreturn]] void Refuse(const std::string& option, const std::string& value,
                         const std::string& why) {
  throw hardware::ConfigError({{option, value, why}});
}

fs::path SceneFile(const RenderArguments& a) {
  const fs::path scenes = ScenesDir();
  if (fs::is_regular_file(scenes / a.scene)) return scenes / a.scene;
  Refuse("SCENE", a.scene,
         "is not in " + scenes.string() + DidYouMean(a.scene, SceneNames(scenes)));
}

/// The robot named, or the one whose folder the scene is in.
RobotDescription Robot(const RenderArguments& a) {
  const fs::path scenes = ScenesDir();
  const std::string name = a.robot.empty() ? fs::path(a.scene).begin()->string() : a.robot;
  const fs::path file = RobotFile(scenes, name);
  if (!fs::is_regular_file(file)) {
    Refuse("--robot", name,
           "has no robot.yaml in " + scenes.string() + DidYouMean(name, RobotNames(scenes)));
  }
  return LoadRobotDescription(file);
}

cv::Size Size(const std::string& text) {
  int width = 0, height = 0;
  char end = 0;
  if (std::sscanf(text.c_str(), "%dx%d%c", &width, &height, &end) != 2) {
    Refuse("--size", text, "must be WIDTHxHEIGHT, e.g. 320x240");
  }
  return {width, height};
}

Interval Single(const std::string& option, const std::string& text) {
  if (text.empty()) return {};
  const Interval interval = ParseInterval(option, text);
  if (interval.low != interval.high) {
    Refuse(option, text, "is a range: say how many gazes to draw from it with --random N");
  }
  return interval;
}

std::vector<Gaze> Gazes(const RenderArguments& a, const RobotDescription& robot) {
  if (!a.poses.empty()) return DecodeGazes(ReadText(a.poses), a.poses);
  if (a.random == 0) {
    return {{Single("--pan", a.pan).low, Single("--tilt", a.tilt).low,
             Single("--vergence", a.vergence).low}};
  }
  GazeBounds bounds;
  if (!a.pan.empty()) bounds.pan_deg = ParseInterval("--pan", a.pan);
  if (!a.tilt.empty()) bounds.tilt_deg = ParseInterval("--tilt", a.tilt);
  if (!a.vergence.empty()) bounds.vergence_deg = ParseInterval("--vergence", a.vergence);
  return SampleGazes(bounds.Within(robot.head_limits), a.random, a.seed.value_or(0));
}

SceneSetup Setup(const RenderArguments& a) {
  SceneSetup setup{SceneFile(a), a.seed, {}, {}};
  if (!a.obstacles.empty() || a.blocked) {
    const Interval count = ParseInterval("--obstacles", a.obstacles.empty() ? "4:9" : a.obstacles);
    setup.room.emplace();
    setup.room->min_obstacles = static_cast<int>(count.low);
    setup.room->max_obstacles = static_cast<int>(count.high);
    setup.room->free_path = !a.blocked;
    setup.room->goals_m = {{3, 0}};
  }
  setup.tabletop.clutter.count = a.clutter;
  if (a.occluded) {
    setup.tabletop.occlusion.emplace();
    setup.tabletop.occlusion->fraction = *a.occluded;
  }
  setup.tabletop.background = a.background;
  if (a.brightness) setup.tabletop.light.brightness = *a.brightness;
  if (a.colour_temperature) setup.tabletop.light.colour_temperature_k = *a.colour_temperature;
  return setup;
}

RenderRequest Request(const RenderArguments& a) {
  RenderRequest request;
  request.setup = Setup(a);
  request.robot = Robot(a);
  request.pairs = a.cameras;
  if (!a.size.empty()) request.size = Size(a.size);
  request.profile = sim::CameraProfile::Named(a.profile);
  request.supersample = a.supersample;
  request.gl_backend = a.gl;
  request.gazes = Gazes(a, request.robot);
  request.truth = a.truth;
  request.views = a.views;
  request.files.png16 = a.png16;
  request.versions = LibraryVersions();
  request.out = a.out;
  return request;
}

int Render(const RenderArguments& a) {
  const RenderRequest request = Request(a);
  InstallStopHandler();
  ContactSheet sheet;
  RenderHooks hooks;
  hooks.interrupted = StopRequested;
  hooks.progress = [](int done, int all) {
    if (all > 1) std::cerr << fmt::format("\rframe {} of {}", done + 1, all) << std::flush;
  };
  if (!a.sheet.empty()) hooks.frame = [&sheet](const DatasetFrame& f) { sheet.Add(f); };
  const bool whole = RenderDataset(request, hooks);
  if (request.gazes.size() > 1) std::cerr << "\n";
  if (!sheet.picture().empty()) WritePng(a.sheet, sheet.picture());
  if (!whole) {
    std::cerr << "horopter render: interrupted; " << a.out << " holds what was finished\n";
    return static_cast<int>(ExitCode::kInfrastructure);
  }
  fmt::print("{} frames: {}\n", request.gazes.size(), (request.out / "manifest.json").string());
  return static_cast<int>(ExitCode::kPassed);
}

void AddGazeOptions(CLI::App& app, RenderArguments& a) {
  app.add_option("--pan", a.pan, "Pan, positive left [deg]; LOW:HIGH with --random")->group("Gaze");
  app.add_option("--tilt", a.tilt, "Tilt, positive down [deg]; LOW:HIGH with --random")
      ->group("Gaze");
  app.add_option(
         "--vergence", a.vergence,
         "Angle between the optical axes, positive converging [deg]; LOW:HIGH with --random")
      ->group("Gaze");
  app.add_option("--poses", a.poses, "CSV file: pan_deg,tilt_deg,vergence_deg; a frame per row")
      ->group("Gaze");
  app.add_option("--random", a.random, "Draw so many gazes, by --seed")
      ->check(CLI::PositiveNumber)
      ->group("Gaze");
}

void AddSceneOptions(CLI::App& app, RenderArguments& a) {
  app.add_option("--seed", a.seed, "Vary the scene, and draw gazes and noise, by this number")
      ->group("Scene");
  app.add_option("--obstacles", a.obstacles,
                 "Generate a room round koala/empty_room.xml with N or MIN:MAX obstacles")
      ->group("Scene");
  app.add_flag("--blocked", a.blocked, "A generated room without a free way")->group("Scene");
  app.add_option("--clutter", a.clutter, "Things on the table that belong to no experiment")
      ->group("Scene");
  app.add_option("--occluded", a.occluded, "Share of the tabletop's target that is hidden, 0 to 1")
      ->group("Scene");
  app.add_option("--background", a.background, "Behind the table: brick, bookshelf, ...")
      ->group("Scene");
  app.add_option("--brightness", a.brightness, "Of the table's lights; 1: as the scene has them")
      ->group("Scene");
  app.add_option("--colour-temperature", a.colour_temperature, "Of the table's lights [K]")
      ->group("Scene");
}

void AddImageOptions(CLI::App& app, RenderArguments& a) {
  app.add_option("--camera", a.cameras, "A pair of the robot's cameras; again for more [all]")
      ->allow_extra_args(false)
      ->group("Images");
  app.add_option("--size", a.size, "WIDTHxHEIGHT [the cameras' own]")->group("Images");
  app.add_option("--profile", a.profile,
                 "What lens and sensor do: ideal, vga_noise, webcam_vga, ...")
      ->capture_default_str()
      ->group("Images");
  app.add_flag("--supersample", a.supersample, "Four samples per pixel")->group("Images");
  app.add_option("--gl", a.gl, "GL backend")->capture_default_str()->group("Images");
  app.add_option("--view", a.views, "Also the scene as a whole, by one of its own cameras")
      ->allow_extra_args(false)
      ->group("Images");
}

}  // namespace

Command AddRenderCommand(CLI::App& parent) {
  CLI::App* app = parent.add_subcommand(
      "render", "Make a data set: stereo pairs of a scene at given gazes, with exact truth");
  // Shared by CLI11, which writes into it while parsing, and the closure that runs afterwards.
  const auto a = std::make_shared<RenderArguments>();
  app->add_option("SCENE", a->scene, "Below the scenes folder, e.g. koala/room.xml")->required();
  app->add_option("--robot", a->robot, "Whose head it is [the scene's folder]");
  app->add_option("--out", a->out, "Folder to make; must not hold anything")->required();
  app->add_flag("--truth", a->truth,
                "Also depth, ids, normals, disparity with occlusion, flow, poses, contacts");
  app->add_flag("--png16", a->png16, "Truth as 16-bit PNG besides .flo and .pfm");
  app->add_option("--sheet", a->sheet, "Also one PNG of the first frames, for people");
  AddGazeOptions(*app, *a);
  AddSceneOptions(*app, *a);
  AddImageOptions(*app, *a);
  app->footer(
      "\nExamples:\n"
      "  horopter render koala/room.xml --pan 10 --vergence 4 --truth --out pair\n"
      "  horopter render yorick/tabletop.xml --seed 3 --clutter 4 --random 20 --truth --out set\n"
      "  horopter render nao/workspace.xml --poses gazes.csv --profile lifecam_vx6000 --out set");
  return {app, [a] { return Render(*a); }};
}

}  // namespace horopter::scenarios
