// SPDX-License-Identifier: Apache-2.0
#include "scenarios/cli/render_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>

#include <initializer_list>
#include <string_view>

#include "scenarios/render/request_checks.h"
#include "sim/render/gl_context.h"
#include "sim/tabletop/light_colour.h"

namespace horopter::scenarios {
namespace {

void AddGazeOptions(CLI::App& app, RenderArguments& a) {
  const std::string group = "Gaze and bodies";
  CLI::Option* poses =
      app.add_option("--poses", a.poses,
                     "CSV file, a frame per row; columns pan_deg,tilt_deg,vergence_deg, or axes as "
                     "left_pan_deg, and of bodies NAME.x_m .y_m .z_m .yaw_deg .pitch_deg .roll_deg")
          ->group(group);
  CLI::Option* random = app.add_option("--random", a.random, "Draw so many gazes, by --seed")
                            ->check(CLI::PositiveNumber)
                            ->excludes(poses)
                            ->group(group);
  CLI::Option* axis =
      app.add_option("--axis", a.axes,
                     fmt::format("NAME=DEG, an axis in place of a gaze; again for more: {}",
                                 fmt::join(hardware::kHeadAxisNames, ", ")))
          ->allow_extra_args(false)
          ->excludes(poses)
          ->excludes(random)
          ->group(group);
  const auto gaze = [&](const char* name, std::string& value, const char* help) {
    app.add_option(name, value, help)->excludes(poses)->excludes(axis)->group(group);
  };
  gaze("--pan", a.pan, "Pan, positive left [deg]; LOW:HIGH with --random");
  gaze("--tilt", a.tilt, "Tilt, positive down [deg]; LOW:HIGH with --random");
  gaze("--vergence", a.vergence,
       "Angle between the optical axes, positive converging [deg]; LOW:HIGH with --random");
  app.add_option("--body", a.bodies,
                 "NAME=X,Y,Z[,YAW,PITCH,ROLL] in the robot's starting frame [m, deg]: where a body "
                 "of the scene is; again for more")
      ->allow_extra_args(false)
      ->group(group);
}

void AddMotionOptions(CLI::App& app, RenderArguments& a) {
  const std::string group = "Motion (the robot moves in time; its cameras run at their rate)";
  CLI::Option* file = app.add_option("--motion", a.motion, "YAML file; see below")->group(group);
  const auto command = [&](const char* name, std::vector<std::string>& values, const char* help) {
    app.add_option(name, values, help)->allow_extra_args(false)->excludes(file)->group(group);
  };
  command("--saccade", a.saccades,
          "NAME=DEG,...[@SECONDS]: pan, tilt and vergence, or axes as left_pan, as fast as the "
          "head can; what is not named stays; again for more");
  command("--walk", a.walks, "X,Y,TURN[@SECONDS]: the NAO walks to there [m, deg]");
  command("--drive", a.drives, "SPEED,TURN[@SECONDS]: the Koala drives [m/s, deg/s]");
  app.add_option("--duration", a.duration_s, "How long the cameras run [s] [1]")
      ->excludes(file)
      ->group(group);
  app.add_option("--rate", a.rate_hz, "Frames a second [the profile's, or 25 where it has none]")
      ->check(CLI::Range(0.1, 1000.0))
      ->group(group);
  app.add_option("--faults", a.faults,
                 "YAML file of a scenario's faults: what is wrong with head and cameras; see below")
      ->group(group);
  for (const char* name : {"--motion", "--saccade", "--walk", "--drive", "--duration", "--rate"}) {
    app.get_option(name)->excludes(app.get_option("--poses"))->excludes(app.get_option("--random"));
  }
}

void AddRoomOptions(CLI::App& app, RenderArguments& a) {
  CLI::Option* obstacles =
      app.add_option("--obstacles", a.obstacles,
                     "Generate a room: N or MIN:MAX obstacles in koala/empty_room.xml")
          ->group("Scene");
  app.add_option("--goal", a.goal,
                 "X,Y that the room's free path leads to, in the robot's starting frame [m] [3,0]")
      ->needs(obstacles)
      ->group("Scene");
  CLI::Option* clearance = app.add_option("--clearance", a.clearance_m,
                                          "That the free path keeps round the robot [m] [0.35]")
                               ->check(CLI::Range(0.001, 2.0))
                               ->needs(obstacles)
                               ->group("Scene");
  app.add_flag("--blocked", a.blocked, "A generated room without a free way to the goal")
      ->needs(obstacles)
      ->excludes(clearance)
      ->group("Scene");
}

void AddTableOptions(CLI::App& app, RenderArguments& a) {
  CLI::Option* obstacles = app.get_option("--obstacles");
  const auto table = [&](CLI::Option* option) { option->excludes(obstacles)->group("Scene"); };
  table(app.add_option("--clutter", a.clutter, "Things on the table that belong to no experiment")
            ->check(CLI::Range(0, 100)));
  table(app.add_option("--occluded", a.occluded, "Share of the tabletop's target that is hidden")
            ->check(CLI::Range(0.05, 0.95)));
  table(app.add_option("--background", a.background, "Behind the table; see below [drawn]"));
  table(app.add_option("--brightness", a.brightness,
                       "Of the table's lights; 1: as the scene has them")
            ->check(CLI::Range(0.05, 2.0)));
  table(app.add_option("--colour-temperature", a.colour_temperature_k, "Of the table's lights [K]")
            ->check(CLI::Range(sim::kLowestColourTemperature_k, sim::kHighestColourTemperature_k)));
}

void AddImageOptions(CLI::App& app, RenderArguments& a) {
  app.add_option("--camera", a.cameras, "A pair of the robot's cameras; again for more [all]")
      ->allow_extra_args(false)
      ->group("Images");
  CLI::Option* file =
      app.add_option("--camera-file", a.camera_file,
                     "YAML with the keys of a scenario's camera: profile, lens, noise, width, ...")
          ->group("Images");
  app.add_option("--size", a.size, "WIDTHxHEIGHT [the cameras' own]")
      ->excludes(file)
      ->group("Images");
  app.add_option("--profile", a.profile, "What lens and sensor do")
      ->check(CLI::IsMember(sim::CameraProfile::Names()))
      ->excludes(file)
      ->capture_default_str()
      ->group("Images");
  app.add_flag("--supersample", a.supersample, "Four samples per pixel")->group("Images");
  std::vector<std::string> backends;
  for (const std::string_view name : sim::GlBackends()) backends.emplace_back(name);
  app.add_option("--gl", a.gl, "GL backend")
      ->check(CLI::IsMember(backends))
      ->capture_default_str()
      ->group("Images");
  app.add_option("--view", a.views,
                 "Also the scene as a whole, by one of its own cameras; see below; again for more")
      ->allow_extra_args(false)
      ->group("Images");
}

/// A manifest has decided everything but where the set goes.
void RefuseBesideAgain(const CLI::App& app, const CLI::Option& again) {
  if (again.count() == 0) return;
  for (const CLI::Option* option : app.get_options()) {
    const std::string name = option->get_name();
    if (option == &again || name == "--out" || name == "--sheet" || option->count() == 0) continue;
    throw CLI::ExcludesError("--again", name);
  }
}

std::string Footer() {
  std::string text = "\nScenes, with their views and backgrounds:\n";
  for (const SceneListing& scene : ListScenes()) {
    text += fmt::format("  {}: {}", scene.name, fmt::join(scene.views, ", "));
    if (!scene.backgrounds.empty()) {
      text += fmt::format("; before {}", fmt::join(scene.backgrounds, ", "));
    }
    text += "\n";
  }
  return text +
         "\nTruth: left_disparity.flo lies on the left image's pixels and leads to the right; "
         "A_to_B_disparity.flo\nlies on A's. left_flow_previous_to_this.flo lies on the pixels of "
         "the frame before. Normals are in the\noptical frame of their camera. manifest.json says "
         "all conventions.\n"
         "\nA motion begins where --pan and the like say. Its file:\n"
         "  duration_s: 6\n"
         "  commands:\n"
         "    - saccade: {at_s: 0.5, pan_deg: 20, tilt_deg: -5}  # or axes: neck_pan_deg, ...\n"
         "    - walk_to: {at_s: 1, x_m: 0.3, turn_deg: 20}       # NAO, from where it stands then\n"
         "    - walk: {at_s: 5, forward_m_s: 0.05}               # NAO, until told otherwise\n"
         "    - drive: {forward_m_s: 0.2, turn_deg_s: 10}        # Koala, until told otherwise\n"
         "trajectory.csv has base and head at every physics step, capture.csv the times of every "
         "image and\nof its first and last row. Truth is a global shutter's view in the middle of "
         "the exposure: with a rolling\nor interlaced shutter the rows of a moving image lie "
         "beside it.\n"
         "\nFaults, as a scenario has them: backlash, encoder_bias, encoder_noise, stuck_axis, "
         "zero_off, wrong_baseline,\nmisaligned_eye, swapped_pair, dark_eye, frozen_frames, "
         "lost_frames. Their file:\n"
         "  faults:\n"
         "    - zero_off: {eye: left, pan_deg: 2}\n"
         "    - dark_eye: {eye: right, light: 0.1, from_s: 0.5}\n"
         "\nExamples:\n"
         "  horopter render koala/room.xml --pan 10 --vergence 4 --truth --out pair\n"
         "  horopter render yorick/tabletop.xml --seed 3 --clutter 4 --random 20 --truth --out "
         "set\n"
         "  horopter render nao/workspace.xml --poses board.csv --profile lifecam_vx6000 --out "
         "set\n"
         "  horopter render yorick/tabletop.xml --tilt 20 --saccade pan=25,tilt=20@0.1 --duration "
         "0.4 --profile sony_xc999 --out set\n"
         "  horopter render nao/workspace.xml --walk 0.3,0,20 --duration 6 --profile webcam_vga "
         "--out set\n"
         "  horopter render --again set/manifest.json --out same";
}

}  // namespace

void AddRenderOptions(CLI::App& app, RenderArguments& a) {
  app.add_option("SCENE", a.scene, "Below the scenes folder, e.g. koala/room.xml");
  CLI::Option* again = app.add_option(
      "--again", a.again, "Make the data set of this manifest.json once more, bit for bit");
  app.add_option("--robot", a.robot, "Whose head it is [the scene's folder]");
  app.add_option("--out", a.out, "Folder to make; must not hold anything")->required();
  CLI::Option* truth = app.add_flag(
      "--truth", a.truth,
      "Also depth, ids, normals, disparity with occlusion, flow, poses, contacts; of a "
      "moving camera at the middle of the exposure, as by a global shutter");
  app.add_flag("--png16", a.png16, "Truth as 16-bit PNG besides .flo and .pfm")->needs(truth);
  app.add_option("--truth-between", a.between,
                 "CAMERA:CAMERA, by their images' names, as peripheral_left:foveal_left: disparity "
                 "and occlusion between them, both ways; again for more")
      ->allow_extra_args(false)
      ->needs(truth);
  app.add_option("--sheet", a.sheet, "Also one PNG of frames spread over the set, for people");
  AddGazeOptions(app, a);
  AddMotionOptions(app, a);
  app.add_option("--seed", a.seed, "Vary the scene, and draw gazes and noise, by this number")
      ->group("Scene");
  AddRoomOptions(app, a);
  AddTableOptions(app, a);
  AddImageOptions(app, a);
  app.callback([&app, again] { RefuseBesideAgain(app, *again); });
  app.footer(Footer);
}

}  // namespace horopter::scenarios
