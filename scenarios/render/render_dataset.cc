// SPDX-License-Identifier: Apache-2.0
#include "scenarios/render/render_dataset.h"

#include <fmt/format.h>

#include <opencv2/core/mat.hpp>
#include <optional>
#include <vector>

#include "scenarios/dataset/png16.h"
#include "scenarios/format/scenes.h"
#include "scenarios/render/film.h"
#include "scenarios/render/request_checks.h"
#include "scenarios/render/scene_files.h"
#include "scenarios/render/stage.h"
#include "scenarios/results/append_file.h"
#include "scenarios/results/files.h"
#include "scenarios/runner/room_setup.h"
#include "sim/head/pose_head.h"

namespace horopter::scenarios {
namespace {

/// What still views cannot show of a camera's profile.
std::map<std::string, std::string> LeftOutOf(const RenderRequest& request) {
  std::map<std::string, std::string> left_out;
  if (request.motion) return left_out;
  const sim::CameraProfile& profile = request.camera.profile;
  if (profile.exposure.time_s > 0) {
    left_out["exposure.time_s"] = "nothing moves in a still view: no motion blur";
  }
  if (profile.shutter.kind != sim::Shutter::kGlobal) {
    left_out["shutter"] = "nothing moves in a still view: all rows show one instant";
  }
  if (profile.timing != sim::TimingProfile{}) {
    left_out["timing"] = "no time passes between still views: every frame is there, at once";
  }
  return left_out;
}

DatasetInfo InfoOf(const RenderRequest& request, const RenderOutput& output,
                   const SceneHashes& scene, const std::string& gl_renderer) {
  return {.scene = request.scene,
          .seed = request.seed,
          .gl_renderer = gl_renderer,
          .versions = output.versions,
          .robot = request.robot,
          .gl_backend = request.gl,
          .command = output.command,
          .request = EncodeRequest(request),
          .left_out_of_profile = LeftOutOf(request),
          .scene_sha256 = scene};
}

std::optional<sim::SceneLegend> LegendOf(const RenderRequest& request, const mjModel& model) {
  if (!request.truth) return std::nullopt;
  return sim::SceneLegend(model);
}

/// What there is besides the frames.
struct Extras {
  SceneHashes scene_sha256;
  std::vector<cv::Mat3b> overviews;  ///< of the request's views
  std::optional<sim::Room> room;
};

/// @return the files' names
std::vector<std::string> Write(const Extras& extras, const RenderRequest& request,
                               const std::filesystem::path& folder) {
  std::vector<std::string> files;
  for (std::size_t i = 0; i < extras.overviews.size(); ++i) {
    files.push_back(request.views[i] + ".png");
    WritePng(folder / files.back(), extras.overviews[i]);
  }
  if (extras.room) {
    WriteFileAtomically(folder / "room.json", RoomText(*extras.room));
    WriteFileAtomically(folder / "room.xml", extras.room->mjcf);
    files.insert(files.end(), {"room.json", "room.xml"});
  }
  return files;
}

SceneHashes HashesOf(const RenderRequest& request, const Scenery& scenery) {
  const std::string mjcf =
      scenery.room ? scenery.room->mjcf : ResolveScene(ScenesDir() / request.scene);
  return HashScene(request, mjcf, scenery.world->model());
}

std::vector<cv::Mat3b> OverviewsBy(Stage& stage, const RenderRequest& request) {
  std::vector<cv::Mat3b> overviews;
  for (const std::string& view : request.views) overviews.push_back(stage.Overview(view));
  return overviews;
}

/// @return whether all frames were taken
bool WriteStills(const RenderRequest& request, const RobotDescription& robot,
                 const std::vector<PosedView>& views, Scenery& scenery, const RenderOutput& output,
                 const RenderHooks& hooks) {
  Stage stage(request, robot, scenery);
  const Extras extras{HashesOf(request, scenery), OverviewsBy(stage, request), scenery.room};
  DatasetWriter writer(output.folder,
                       InfoOf(request, output, extras.scene_sha256, stage.gl_renderer()),
                       LegendOf(request, scenery.world->model()), {.png16 = request.png16});
  const std::vector<std::string> others = Write(extras, request, output.folder);
  const int all = static_cast<int>(views.size());
  for (int i = 0; i < all; ++i) {
    hooks.progress(i, all);
    if (hooks.interrupted()) return false;
    const DatasetFrame frame = stage.See(views[static_cast<std::size_t>(i)]);
    writer.AddFrame(frame);
    hooks.frame(frame);
  }
  writer.Finish(others);
  return true;
}

/// Rows of capture.csv.
void Append(const std::vector<Film::Capture>& captures, int frame, AppendFile& file) {
  for (const Film::Capture& c : captures) {
    std::string row = fmt::format("{},{},{}", frame, c.pair, c.sequence);
    for (const hardware::Eye eye : hardware::kBothEyes) {
      const hardware::Time t = c.t_capture[eye];
      for (const hardware::Time at : {t, t - c.half_readout, t + c.half_readout}) {
        row += fmt::format(",{:.9f}", hardware::ToSeconds(at));
      }
    }
    file.Append(row + fmt::format(",{:.9f}", hardware::ToSeconds(c.t_delivered)));
  }
}

/// Likewise.
bool WriteFilm(const RenderRequest& request, const RobotDescription& robot,
               const hardware::HeadAngles& start, Scenery& scenery, const RenderOutput& output,
               const RenderHooks& hooks) {
  Extras extras{HashesOf(request, scenery), {}, scenery.room};
  sim::PoseHead(*scenery.world, start);
  if (!request.views.empty()) {
    Stage stage(request, robot, scenery);
    extras.overviews = OverviewsBy(stage, request);
  }
  Film film(request, robot, start, scenery);
  DatasetWriter writer(output.folder,
                       InfoOf(request, output, extras.scene_sha256, film.gl_renderer()),
                       LegendOf(request, film.model()), {.png16 = request.png16});
  std::vector<std::string> others = Write(extras, request, output.folder);
  others.insert(others.end(), {"capture.csv", "trajectory.csv"});
  AppendFile captures(output.folder / "capture.csv",
                      "frame,pair,sequence,left_t_s,left_first_row_t_s,left_last_row_t_s,right_t_s,"
                      "right_first_row_t_s,right_last_row_t_s,t_delivered_s");
  AppendFile trajectory(output.folder / "trajectory.csv", StateLog::Header());
  const int all = film.ExpectedFrames();
  for (int i = 0;; ++i) {
    if (i < all) hooks.progress(i, all);
    if (hooks.interrupted()) return false;
    const auto frame = film.Next();
    if (!frame) break;
    writer.AddFrame(frame->content);
    Append(frame->captures, i, captures);
    trajectory.Append(frame->states);
    hooks.frame(frame->content);
  }
  if (const std::string rest = film.RestOfStates(); !rest.empty()) trajectory.Append(rest);
  const std::vector<CommandOutcome> outcomes = film.Outcomes();
  writer.Finish(others, EncodeOutcomes(outcomes));
  if (const std::string not_reached = WhatWasNotReached(outcomes); !not_reached.empty()) {
    hooks.note(not_reached);
  }
  return true;
}

}  // namespace

bool RenderDataset(const RenderRequest& request, const RenderOutput& output,
                   const RenderHooks& hooks) {
  const RobotDescription robot = RobotOf(request);
  CheckRequest(request, robot);
  const std::vector<PosedView> views = ViewsOf(request.poses, HeadReach(robot));
  Scenery scenery = LoadScene(request);
  if (!views.empty()) PlaceBodies(scenery, views.front().bodies);
  return request.motion ? WriteFilm(request, robot, views.front().head, scenery, output, hooks)
                        : WriteStills(request, robot, views, scenery, output, hooks);
}

}  // namespace horopter::scenarios
