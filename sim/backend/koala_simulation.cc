// SPDX-License-Identifier: Apache-2.0
#include "sim/backend/koala_simulation.h"

#include <cmath>
#include <utility>

#include "sim/backend/sim_device.h"

namespace horopter::sim {
namespace {

using hardware::Duration;
using hardware::Error;
using hardware::ErrorCode;
using hardware::Eye;
using hardware::Result;

/// Long enough for the wheels to take up the robot's weight and for the body to stop swinging.
constexpr Duration kSettleTime = std::chrono::milliseconds(400);

std::unique_ptr<World> FurnishedWorld(const KoalaSimulationConfig& config) {
  auto world = config.scene_text.empty() ? std::make_unique<World>(config.scene)
                                         : World::FromXml(config.scene_text);
  Vary(*world, config.variation, config.seed);
  return world;
}

}  // namespace

class KoalaSimulation::SimBase final : public SimDevice<hardware::MobileBase> {
 public:
  explicit SimBase(KoalaSimulation& sim) : sim_(sim) {}

  Result<hardware::BaseState> Read() override {
    if (const auto allowed = Require("Read", true); !allowed.ok()) return allowed.error();
    const WheelPulses pulses = sim_.plant_->Encoders();
    const auto proximity = sim_.plant_->Proximity();
    return hardware::BaseState{
        sim_.clock_device_->Now(), pulses.left, pulses.right, {proximity.begin(), proximity.end()}};
  }

  Result<void> Command(const hardware::WheelSpeeds& speeds) override {
    if (const auto allowed = Require("Command", false); !allowed.ok()) return allowed;
    if (!std::isfinite(speeds.left_m_s) || !std::isfinite(speeds.right_m_s)) {
      return Error{ErrorCode::kOutOfRange, "base command: both wheel speeds must be finite"};
    }
    sim_.plant_->Command(speeds);
    return {};
  }

  hardware::BaseProperties properties() const override { return sim_.config_.base; }

 private:
  void StopMotion() override { sim_.plant_->Command({0, 0}); }
  void OnFirstConfigure() override { sim_.plant_->SetEncoders({}); }

  KoalaSimulation& sim_;
};

KoalaSimulation::KoalaSimulation(const KoalaSimulationConfig& config, hardware::StageTimes& times)
    : KoalaSimulation(FurnishedWorld(config), config, times) {}

KoalaSimulation::KoalaSimulation(std::unique_ptr<World> world, const KoalaSimulationConfig& config,
                                 hardware::StageTimes& times)
    : config_(config), world_(std::move(world)) {
  config_.head.time_zero = kSettleTime;
  head_ = std::make_unique<VirtualHead>(*world_, config_.head);
  plant_ = std::make_unique<KoalaPlant>(*world_, config.plant);
  Settle();
  for (const auto& [body, X_OBody] : config.X_OBody) world_->PlaceBody(body, X_WO_ * X_OBody);
  const SimCamerasConfig cameras{.model = {config.camera, config.camera},
                                 .profile = config.profile,
                                 .seed = config.seed,
                                 .faults = config.head.faults};
  const cv::Size render_size = cameras.RenderSize();
  RendererOptions options;
  options.gl_backend = config.gl_backend;
  options.supersample = config.supersample;
  options.width = render_size.width;
  options.height = render_size.height;
  renderer_ = std::make_unique<Renderer>(*world_, options);

  clock_device_ = std::make_unique<SimClock>(
      *world_, [this] { Step(); }, times);
  head_device_ = std::make_unique<SimHead>(*head_, *clock_device_);
  camera_device_ =
      std::make_unique<SimCameras>(*world_, *renderer_, *clock_device_, cameras, times);
  base_device_ = std::make_unique<SimBase>(*this);
}

KoalaSimulation::~KoalaSimulation() = default;

void KoalaSimulation::OnStep(std::function<void(const World&)> observer) {
  clock_device_->OnStep(std::move(observer));
}

RenderedView KoalaSimulation::RenderTruth(Eye eye) {
  return renderer_->Render(world_->X_WCamera(ToString(eye)), config_.camera,
                           {.rgb = false, .depth = true, .ids = true});
}

void KoalaSimulation::AtCapture(Eye eye, const std::function<void()>& look) {
  camera_device_->AtCapture(eye, look);
}

void KoalaSimulation::Step() {
  head_->Update();
  plant_->Update();
  world_->Step();
}

void KoalaSimulation::Settle() {
  while (world_->now().time_since_epoch() < kSettleTime) Step();
  X_WO_ = hardware::ToPose(hardware::ToPose2(world_->X_WBody("base")));
}

hardware::Clock& KoalaSimulation::clock() { return *clock_device_; }
hardware::StereoHead& KoalaSimulation::head() { return *head_device_; }
hardware::CameraPair& KoalaSimulation::cameras() { return *camera_device_; }
hardware::MobileBase& KoalaSimulation::base() { return *base_device_; }

}  // namespace horopter::sim
