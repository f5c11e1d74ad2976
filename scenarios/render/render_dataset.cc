// SPDX-License-Identifier: Apache-2.0
#include "scenarios/render/render_dataset.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <utility>

#include "hardware/types/config_error.h"
#include "scenarios/dataset/png16.h"
#include "sim/camera/eye_camera.h"
#include "sim/head/pose_head.h"
#include "sim/render/renderer.h"

namespace horopter::scenarios {
namespace {

using hardware::Eye;

constexpr double kRadians = M_PI / 180;
const cv::Size kViewSize{960, 720};

/// A pair of the robot's cameras, ready to take pictures.
struct Pair {
  std::string name;
  hardware::PerEye<std::string> mjcf_camera;
  hardware::PerEye<std::unique_ptr<sim::EyeCamera>> camera;
};

std::vector<std::string> PairNames(const RenderRequest& request) {
  if (!request.pairs.empty()) return request.pairs;
  std::vector<std::string> names;
  for (const auto& [name, pair] : request.robot.cameras) names.push_back(name);
  return names;
}

std::vector<Pair> MakePairs(const RenderRequest& request) {
  std::vector<Pair> pairs;
  const auto names = PairNames(request);
  for (const std::string& name : names) {
    const CameraPairDescription& description = request.robot.Cameras(name);
    const cv::Size size =
        request.size.value_or(cv::Size(description.width_px, description.height_px));
    const hardware::CameraModel model = request.profile.lens.Model(
        size.width, size.height, description.horizontal_fov_deg * kRadians);
    Pair pair{names.size() > 1 ? name : "", {description.left, description.right}, {}};
    for (const Eye eye : hardware::kBothEyes) {
      pair.camera[eye] = std::make_unique<sim::EyeCamera>(
          model, request.profile, request.setup.seed.value_or(0), pair.mjcf_camera[eye]);
    }
    pairs.push_back(std::move(pair));
  }
  return pairs;
}

sim::RendererOptions OptionsFor(const RenderRequest& request, const std::vector<Pair>& pairs) {
  sim::RendererOptions options;
  options.gl_backend = request.gl_backend;
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

/// What there is to see in a world, frame after frame.
class Stage {
 public:
  Stage(const RenderRequest& request, sim::World& world)
      : request_(request),
        world_(world),
        pairs_(MakePairs(request)),
        renderer_(world, OptionsFor(request, pairs_)) {
    if (request.truth) shapes_ = std::make_shared<const sim::SceneShapes>(world.model());
  }

  std::string gl_renderer() const { return renderer_.gl_renderer(); }

  DatasetFrame See(const Gaze& gaze) {
    DatasetFrame frame;
    frame.head = AnglesOf(gaze, request_.robot.head_limits);
    frame.t = hardware::Time(hardware::Duration(std::chrono::seconds(count_)));
    sim::PoseHead(world_, frame.head);
    for (Pair& pair : pairs_) frame.pairs.push_back(Photograph(pair));
    if (request_.truth) AddTruth(frame);
    ++count_;
    return frame;
  }

  /// The scene by one of its own cameras.
  cv::Mat3b Overview(const std::string& mjcf_camera) {
    const int id = world_.Id(mjOBJ_CAMERA, mjcf_camera);
    const double half_height = std::tan(world_.model().cam_fovy[id] * kRadians / 2);
    const double fov = 2 * std::atan(half_height * kViewSize.width / kViewSize.height);
    const auto camera =
        hardware::CameraModel::FromHorizontalFov(kViewSize.width, kViewSize.height, fov);
    return renderer_.Render(world_.X_WCamera(mjcf_camera), camera).bgr;
  }

 private:
  DatasetPair Photograph(Pair& pair) {
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
      return DatasetEye{.view = view,
                        .bgr = pair.camera[eye]->Develop(std::move(views[index].bgr), still,
                                                         static_cast<std::uint64_t>(count_))};
    };
    return {pair.name, develop(Eye::kLeft), develop(Eye::kRight)};
  }

  /// What a pair saw in the frame before.
  struct Seen {
    sim::EyeTruth left;
    sim::EyeTruth right;
  };

  void AddTruth(DatasetFrame& frame) {
    const sim::SceneSnapshot now(shapes_, world_.data());
    frame.state = sim::ReadWorldState(world_);
    for (DatasetPair& pair : frame.pairs) {
      pair.left.truth = sim::CaptureEyeTruth(now, pair.left.view);
      pair.right.truth = sim::CaptureEyeTruth(now, pair.right.view);
      pair.left.to_other_eye = sim::TrueDisparity(now, *pair.left.truth, pair.right.view);
      pair.right.to_other_eye = sim::TrueDisparity(now, *pair.right.truth, pair.left.view);
      const auto before = previous_.find(pair.name);
      if (before != previous_.end()) {
        pair.left.flow_from_previous =
            sim::TrueFlow(*then_, before->second.left, now, pair.left.view);
        pair.right.flow_from_previous =
            sim::TrueFlow(*then_, before->second.right, now, pair.right.view);
      }
      previous_.insert_or_assign(pair.name, Seen{*pair.left.truth, *pair.right.truth});
    }
    then_ = now;
  }

  const RenderRequest& request_;
  sim::World& world_;
  std::vector<Pair> pairs_;
  sim::Renderer renderer_;
  std::shared_ptr<const sim::SceneShapes> shapes_;
  std::optional<sim::SceneSnapshot> then_;
  std::map<std::string, Seen> previous_;  ///< by pair
  int count_ = 0;
};

DatasetInfo InfoOf(const RenderRequest& request, const Stage& stage) {
  return {request.setup.scene.filename().string(), request.setup.seed.value_or(0),
          stage.gl_renderer(), request.versions};
}

}  // namespace

bool RenderDataset(const RenderRequest& request, const RenderHooks& hooks) {
  for (const Gaze& gaze : request.gazes) AnglesOf(gaze, request.robot.head_limits);
  const auto world = LoadScene(request.setup);
  Stage stage(request, *world);
  std::optional<sim::SceneLegend> legend;
  if (request.truth) legend.emplace(world->model());
  DatasetWriter writer(request.out, InfoOf(request, stage), legend, request.files);
  for (const std::string& view : request.views) {
    WritePng(request.out / (view + ".png"), stage.Overview(view));
  }
  const int all = static_cast<int>(request.gazes.size());
  for (int i = 0; i < all; ++i) {
    hooks.progress(i, all);
    if (hooks.interrupted()) return false;
    const DatasetFrame frame = stage.See(request.gazes[static_cast<std::size_t>(i)]);
    writer.AddFrame(frame);
    hooks.frame(frame);
  }
  writer.Finish();
  return true;
}

}  // namespace horopter::scenarios
