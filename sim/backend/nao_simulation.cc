// SPDX-License-Identifier: Apache-2.0
#include "sim/backend/nao_simulation.h"

#include <utility>

namespace horopter::sim {

using hardware::Eye;

namespace {

/// Long enough for the legs to take up the robot's weight and for the body to stop swinging.
constexpr hardware::Duration kSettleTime = std::chrono::milliseconds(600);

std::unique_ptr<World> FurnishedWorld(const NaoSimulationConfig& config) {
  auto world = std::make_unique<World>(config.scene);
  Vary(*world, config.variation, config.seed);
  return world;
}

}  // namespace

NaoSimulation::NaoSimulation(const NaoSimulationConfig& config, hardware::StageTimes& times)
    : NaoSimulation(FurnishedWorld(config), config, times) {}

NaoSimulation::NaoSimulation(std::unique_ptr<World> world, const NaoSimulationConfig& config,
                             hardware::StageTimes& times)
    : config_(config), world_(std::move(world)) {
  MakeRobot();
  for (const auto& [body, X_OBody] : config.X_OBody) world_->PlaceBody(body, X_WO_ * X_OBody);
  MakeDevices(times);
}

NaoSimulation::~NaoSimulation() = default;

void NaoSimulation::MakeRobot() {
  config_.head.time_zero = kSettleTime;
  head_ = std::make_unique<VirtualHead>(*world_, config_.head);
  plant_ = std::make_unique<NaoPlant>(*world_, NaoPlantConfig{config_.gait, config_.seed});
  while (world_->now().time_since_epoch() < kSettleTime) Step();
  X_WO_ = hardware::ToPose(plant_->TruePose());
}

void NaoSimulation::MakeDevices(hardware::StageTimes& times) {
  const SimCamerasConfig cameras{.mjcf_camera = {CameraName(Eye::kLeft), CameraName(Eye::kRight)},
                                 .model = {config_.camera, config_.camera},
                                 .profile = config_.profile,
                                 .seed = config_.seed,
                                 .faults = config_.head.faults};
  const cv::Size render_size = cameras.RenderSize();
  RendererOptions options;
  options.gl_backend = config_.gl_backend;
  options.supersample = config_.supersample;
  options.width = render_size.width;
  options.height = render_size.height;
  renderer_ = std::make_unique<Renderer>(*world_, options);

  clock_device_ = std::make_unique<SimClock>(
      *world_, [this] { Step(); }, times);
  head_device_ = std::make_unique<SimHead>(*head_, *clock_device_);
  camera_device_ =
      std::make_unique<SimCameras>(*world_, *renderer_, *clock_device_, cameras, times);
  humanoid_device_ = std::make_unique<SimHumanoid>(*plant_, *clock_device_);
}

void NaoSimulation::Step() {
  // The plant comes second: it keeps the head's pitch within what the yaw allows.
  head_->Update();
  plant_->Update();
  world_->Step();
}

RenderedView NaoSimulation::RenderTruth(Eye eye) {
  return renderer_->Render(world_->X_WCamera(CameraName(eye)), config_.camera,
                           {.rgb = false, .depth = true, .ids = true});
}

void NaoSimulation::AtCapture(Eye eye, const std::function<void()>& look) {
  camera_device_->AtCapture(eye, look);
}

}  // namespace horopter::sim
