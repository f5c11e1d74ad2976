// SPDX-License-Identifier: Apache-2.0
#include "scenarios/render/render_dataset.h"

#include <opencv2/core/mat.hpp>
#include <optional>
#include <vector>

#include "scenarios/dataset/png16.h"
#include "scenarios/render/request_checks.h"
#include "scenarios/render/stage.h"
#include "scenarios/results/files.h"
#include "scenarios/runner/room_setup.h"

namespace horopter::scenarios {
namespace {

/// What still views cannot show of a camera's profile.
std::map<std::string, std::string> LeftOutOf(const sim::CameraProfile& profile) {
  std::map<std::string, std::string> left_out;
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

DatasetInfo InfoOf(const RenderRequest& request, const RenderOutput& output, const Stage& stage) {
  return {.scene = request.scene,
          .seed = request.seed,
          .gl_renderer = stage.gl_renderer(),
          .versions = output.versions,
          .robot = request.robot,
          .gl_backend = request.gl,
          .command = output.command,
          .request = EncodeRequest(request),
          .left_out_of_profile = LeftOutOf(request.camera.profile)};
}

}  // namespace

bool RenderDataset(const RenderRequest& request, const RenderOutput& output,
                   const RenderHooks& hooks) {
  const RobotDescription robot = RobotOf(request);
  CheckRequest(request, robot);
  const std::vector<PosedView> views = ViewsOf(request.poses, HeadReach(robot));
  Scenery scenery = LoadScene(request);
  if (!views.empty()) PlaceBodies(scenery, views.front().bodies);
  Stage stage(request, robot, scenery);
  std::vector<cv::Mat3b> overviews;
  for (const std::string& view : request.views) overviews.push_back(stage.Overview(view));
  std::optional<sim::SceneLegend> legend;
  if (request.truth) legend.emplace(scenery.world->model());

  DatasetWriter writer(output.folder, InfoOf(request, output, stage), legend,
                       {.png16 = request.png16});
  for (std::size_t i = 0; i < overviews.size(); ++i) {
    WritePng(output.folder / (request.views[i] + ".png"), overviews[i]);
  }
  if (scenery.room) {
    WriteFileAtomically(output.folder / "room.json", RoomText(*scenery.room));
    WriteFileAtomically(output.folder / "room.xml", scenery.room->mjcf);
  }
  const int all = static_cast<int>(views.size());
  for (int i = 0; i < all; ++i) {
    hooks.progress(i, all);
    if (hooks.interrupted()) return false;
    const DatasetFrame frame = stage.See(views[static_cast<std::size_t>(i)]);
    writer.AddFrame(frame);
    hooks.frame(frame);
  }
  writer.Finish();
  return true;
}

}  // namespace horopter::scenarios
