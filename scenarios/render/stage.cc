// SPDX-License-Identifier: Apache-2.0
#include "scenarios/render/stage.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "scenarios/render/camera_models.h"
#include "scenarios/render/request_checks.h"
#include "sim/head/pose_head.h"

namespace horopter::scenarios {
namespace {

using hardware::Eye;

constexpr double kRadians = M_PI / 180;
const cv::Size kViewSize{960, 720};

}  // namespace

Stage::Stage(const RenderRequest& request, const RobotDescription& robot, Scenery& scenery)
    : request_(request),
      scenery_(scenery),
      world_(*scenery.world),
      pairs_(MakePairs(request, robot)),
      renderer_(world_, OptionsFor(request, pairs_)) {
  if (request.truth) truth_.emplace(request, world_.model());
}

std::vector<Stage::Pair> Stage::MakePairs(const RenderRequest& request,
                                          const RobotDescription& robot) {
  std::vector<Pair> pairs;
  const auto names = PairNames(request, robot);
  for (const std::string& name : names) {
    const CameraPairDescription& description = robot.Cameras(name);
    const hardware::CameraModel model = CameraModelOf(request.camera, description);
    Pair pair{names.size() > 1 ? name : "", {description.left, description.right}, {}};
    for (const Eye eye : hardware::kBothEyes) {
      pair.camera[eye] = std::make_unique<sim::EyeCamera>(
          model, request.camera.profile, request.seed.value_or(0), pair.mjcf_camera[eye]);
    }
    pairs.push_back(std::move(pair));
  }
  return pairs;
}

sim::RendererOptions Stage::OptionsFor(const RenderRequest& request,
                                       const std::vector<Pair>& pairs) {
  sim::RendererOptions options;
  options.gl_backend = request.gl;
  options.supersample = request.supersample;
  cv::Size largest = request.views.empty() ? cv::Size() : kViewSize;
  for (const Pair& pair : pairs) {
    for (const Eye eye : hardware::kBothEyes) {
      const cv::Size size = pair.camera[eye]->largest_view();
      largest = {std::max(largest.width, size.width), std::max(largest.height, size.height)};
    }
  }
  options.width = largest.width;
  options.height = largest.height;
  return options;
}

DatasetFrame Stage::See(const PosedView& view) {
  DatasetFrame frame;
  frame.head = view.head;
  frame.t = hardware::Time(hardware::Duration(std::chrono::seconds(count_)));
  PlaceBodies(scenery_, view.bodies);
  sim::PoseHead(world_, frame.head);
  for (Pair& pair : pairs_) frame.pairs.push_back(Photograph(pair));
  if (truth_) {
    frame.state = sim::ReadWorldState(world_);
    const FrameTruth::Scene now = truth_->SceneOf(world_.data());
    truth_->Add({pairs_.size(), {now, now}}, frame);
  }
  ++count_;
  return frame;
}

cv::Mat3b Stage::Overview(const std::string& mjcf_camera) {
  const int id = world_.Id(mjOBJ_CAMERA, mjcf_camera);
  const double half_height = std::tan(world_.model().cam_fovy[id] * kRadians / 2);
  const double fov = 2 * std::atan(half_height * kViewSize.width / kViewSize.height);
  const auto camera =
      hardware::CameraModel::FromHorizontalFov(kViewSize.width, kViewSize.height, fov);
  return renderer_.Render(world_.X_WCamera(mjcf_camera), camera).bgr;
}

DatasetPair Stage::Photograph(Pair& pair) {
  const sim::EyeMotion still;
  std::vector<sim::PosedCamera> cameras;
  for (const Eye eye : hardware::kBothEyes) {
    cameras.push_back({world_.X_WCamera(pair.mjcf_camera[eye]), pair.camera[eye]->View(still)});
  }
  auto views = renderer_.RenderAll(cameras);
  const auto develop = [&](Eye eye) {
    const auto index = static_cast<std::size_t>(eye);
    const sim::EyeView view{cameras[index].X_WC, pair.camera[eye]->model(),
                            renderer_.options().near_m, renderer_.options().far_m};
    cv::Mat bgr = pair.camera[eye]->Develop(std::move(views[index].bgr), still,
                                            static_cast<std::uint64_t>(count_));
    return DatasetEye{view, std::move(bgr), {}, {}, {}};
  };
  return {pair.name, develop(Eye::kLeft), develop(Eye::kRight)};
}

}  // namespace horopter::scenarios
