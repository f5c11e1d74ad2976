// SPDX-License-Identifier: Apache-2.0
#include "sim/backend/yorick_simulation.h"

#include <algorithm>
#include <utility>

#include "sim/textures/paint_textures.h"

namespace horopter::sim {

using hardware::Eye;

YorickSimulation::YorickSimulation(const YorickSimulationConfig& config,
                                   hardware::StageTimes& times)
    : config_(config), world_(std::make_unique<World>(config.scene)) {
  Furnish();
  MakeDevices(times);
}

YorickSimulation::YorickSimulation(std::unique_ptr<World> world,
                                   const YorickSimulationConfig& config,
                                   hardware::StageTimes& times)
    : config_(config), world_(std::move(world)) {
  MakeDevices(times);
}

YorickSimulation::~YorickSimulation() = default;

void YorickSimulation::Furnish() {
  if (config_.tabletop) {
    tabletop_ = ArrangeTabletop(*world_, *config_.tabletop, config_.seed);
  } else {
    PaintTextures(world_->mutable_model(), config_.seed);
  }
  for (const auto& [body, X_BBody] : config_.X_BBody) world_->PlaceBody(body, X_WB() * X_BBody);
}

void YorickSimulation::MakeDevices(hardware::StageTimes& times) {
  head_ = std::make_unique<VirtualHead>(*world_, config_.head);
  const auto cameras_of = [this](YorickPair pair) {
    const hardware::CameraModel& model = camera_model(pair);
    return SimCamerasConfig{
        .mjcf_camera = {CameraName(pair, Eye::kLeft), CameraName(pair, Eye::kRight)},
        .model = {model, model},
        .profile = config_.profile,
        .seed = config_.seed,
        .faults = config_.head.faults};
  };
  const SimCamerasConfig peripheral = cameras_of(YorickPair::kPeripheral);
  const SimCamerasConfig foveal = cameras_of(YorickPair::kFoveal);
  const cv::Size wide = peripheral.RenderSize(), narrow = foveal.RenderSize();
  RendererOptions options;
  options.gl_backend = config_.gl_backend;
  options.supersample = config_.supersample;
  options.width = std::max(wide.width, narrow.width);
  options.height = std::max(wide.height, narrow.height);
  renderer_ = std::make_unique<Renderer>(*world_, options);

  clock_device_ = std::make_unique<SimClock>(
      *world_, [this] { Step(); }, times);
  head_device_ = std::make_unique<SimHead>(*head_, *clock_device_);
  peripheral_device_ =
      std::make_unique<SimCameras>(*world_, *renderer_, *clock_device_, peripheral, times);
  foveal_device_ = std::make_unique<SimCameras>(*world_, *renderer_, *clock_device_, foveal, times);
}

void YorickSimulation::Step() {
  head_->Update();
  world_->Step();
}

const hardware::CameraModel& YorickSimulation::camera_model(YorickPair pair) const {
  return pair == YorickPair::kPeripheral ? config_.peripheral : config_.foveal;
}

std::string YorickSimulation::CameraName(YorickPair pair, Eye eye) {
  return std::string(ToString(eye)) + (pair == YorickPair::kPeripheral ? "_peripheral" : "_fovea");
}

RenderedView YorickSimulation::RenderTruth(YorickPair pair, Eye eye) {
  return renderer_->Render(world_->X_WCamera(CameraName(pair, eye)), camera_model(pair),
                           {.rgb = false, .depth = true, .ids = true});
}

void YorickSimulation::AtCapture(YorickPair pair, Eye eye, const std::function<void()>& look) {
  (pair == YorickPair::kPeripheral ? peripheral_device_ : foveal_device_)->AtCapture(eye, look);
}

void YorickSimulation::OnStep(std::function<void(const World&)> observer) {
  clock_device_->OnStep(std::move(observer));
}

hardware::Clock& YorickSimulation::clock() { return *clock_device_; }
hardware::StereoHead& YorickSimulation::head() { return *head_device_; }
hardware::CameraPair& YorickSimulation::cameras(YorickPair pair) {
  return pair == YorickPair::kPeripheral ? *peripheral_device_ : *foveal_device_;
}

}  // namespace horopter::sim
