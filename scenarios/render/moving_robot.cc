// SPDX-License-Identifier: Apache-2.0
#include "scenarios/render/moving_robot.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <utility>

#include "control/base/unicycle.h"
#include "hardware/types/config_error.h"
#include "scenarios/render/camera_models.h"
#include "scenarios/render/request_checks.h"
#include "scenarios/runner/koala_plant_config.h"
#include "sim/backend/koala_simulation.h"
#include "sim/backend/nao_simulation.h"
#include "sim/backend/yorick_simulation.h"

namespace horopter::scenarios {
namespace {

using hardware::Eye;
using sim::YorickPair;

constexpr double kRadians = M_PI / 180;

void Require(const hardware::Result<void>& result) {
  if (!result.ok()) throw sim::PhysicsError(result.error().message);
}

void Start(hardware::Device& device) {
  Require(device.Configure());
  Require(device.Activate());
}

/// What the three simulations are told alike.
template <typename Config>
Config CommonConfig(const RenderRequest& request, const RobotDescription& robot) {
  Config config;
  config.seed = request.seed.value_or(0);
  config.profile = request.camera.profile;
  config.gl_backend = request.gl;
  config.supersample = request.supersample;
  config.head.limits = robot.head_limits;
  config.head.encoder_resolution_rad = robot.encoder_step_deg * kRadians;
  config.head.seed = config.seed;
  return config;
}

/// What the three simulations do alike.
template <typename Simulation>
class Simulated : public MovingRobot {
 public:
  template <typename Config>
  Simulated(std::unique_ptr<sim::World> world, const Config& config, hardware::StageTimes& times)
      : simulation_(std::move(world), config, times) {
    Start(simulation_.head());
  }

  hardware::Clock& clock() override { return simulation_.clock(); }
  hardware::StereoHead& head() override { return simulation_.head(); }
  sim::World& world() override { return simulation_.world(); }
  std::string gl_renderer() const override { return simulation_.gl_renderer(); }
  void OnStep(std::function<void(const sim::World&)> observer) override {
    simulation_.OnStep(std::move(observer));
  }

 protected:
  Simulation simulation_;
};

/// A robot with one pair of cameras.
template <typename Simulation>
class OnePair : public Simulated<Simulation> {
 public:
  template <typename Config>
  OnePair(std::unique_ptr<sim::World> world, const Config& config, hardware::StageTimes& times)
      : Simulated<Simulation>(std::move(world), config, times) {
    Start(this->simulation_.cameras());
  }

  hardware::CameraPair& cameras(const std::string&) override { return this->simulation_.cameras(); }
  hardware::Pose X_WO() const override { return this->simulation_.X_WO(); }
  void AtCapture(const std::string&, Eye eye, const std::function<void()>& look) override {
    this->simulation_.AtCapture(eye, look);
  }
};

class Koala final : public OnePair<sim::KoalaSimulation> {
 public:
  Koala(std::unique_ptr<sim::World> world, const sim::KoalaSimulationConfig& config,
        hardware::StageTimes& times)
      : OnePair(std::move(world), config, times) {
    Start(simulation_.base());
  }

  void Drive(const DriveCommand& command) override {
    hardware::MobileBase& base = simulation_.base();
    Require(base.Command(control::FromTwist({command.forward_m_s, command.turn_deg_s * kRadians},
                                            base.properties())));
  }
};

class Nao final : public OnePair<sim::NaoSimulation> {
 public:
  Nao(std::unique_ptr<sim::World> world, const sim::NaoSimulationConfig& config,
      hardware::StageTimes& times)
      : OnePair(std::move(world), config, times) {
    Start(simulation_.humanoid());
  }

  void WalkTo(const WalkToCommand& command) override {
    Require(simulation_.humanoid().MoveTo({command.x_m, command.y_m, command.turn_deg * kRadians}));
  }
  void Walk(const WalkCommand& command) override {
    Require(simulation_.humanoid().Move(
        {command.forward_m_s, command.left_m_s, command.turn_deg_s * kRadians}));
  }
};

class Yorick final : public Simulated<sim::YorickSimulation> {
 public:
  Yorick(std::unique_ptr<sim::World> world, const sim::YorickSimulationConfig& config,
         const hardware::Pose& X_WO, hardware::StageTimes& times)
      : Simulated(std::move(world), config, times), X_WO_(X_WO) {
    Start(simulation_.cameras(YorickPair::kPeripheral));
    Start(simulation_.cameras(YorickPair::kFoveal));
  }

  hardware::CameraPair& cameras(const std::string& pair) override {
    return simulation_.cameras(PairOf(pair));
  }
  hardware::Pose X_WO() const override { return X_WO_; }
  void AtCapture(const std::string& pair, Eye eye, const std::function<void()>& look) override {
    simulation_.AtCapture(PairOf(pair), eye, look);
  }

 private:
  static YorickPair PairOf(const std::string& pair) {
    return pair == "foveal" ? YorickPair::kFoveal : YorickPair::kPeripheral;
  }

  hardware::Pose X_WO_;
};

}  // namespace

void MovingRobot::WalkTo(const WalkToCommand&) { throw std::logic_error("no legs"); }
void MovingRobot::Walk(const WalkCommand&) { throw std::logic_error("no legs"); }
void MovingRobot::Drive(const DriveCommand&) { throw std::logic_error("no wheels"); }

std::unique_ptr<MovingRobot> MakeMovingRobot(const RenderRequest& request,
                                             const RobotDescription& robot,
                                             std::unique_ptr<sim::World> world,
                                             const hardware::Pose& X_WO,
                                             hardware::StageTimes& times) {
  const auto camera = [&](const std::string& pair) {
    return CameraModelOf(request.camera, robot.Cameras(pair));
  };
  if (robot.name == "koala") {
    auto config = CommonConfig<sim::KoalaSimulationConfig>(request, robot);
    config.camera = camera(PairNames(request, robot).front());
    config.base = robot.wheels.value().properties;
    config.plant = KoalaPlantConfigOf(*robot.wheels);
    return std::make_unique<Koala>(std::move(world), config, times);
  }
  if (robot.name == "nao") {
    auto config = CommonConfig<sim::NaoSimulationConfig>(request, robot);
    config.camera = camera(PairNames(request, robot).front());
    return std::make_unique<Nao>(std::move(world), config, times);
  }
  if (robot.name == "yorick") {
    auto config = CommonConfig<sim::YorickSimulationConfig>(request, robot);
    config.peripheral = camera("peripheral");
    config.foveal = camera("foveal");
    return std::make_unique<Yorick>(std::move(world), config, X_WO, times);
  }
  throw hardware::ConfigError(
      {{"--robot", robot.name, "has no simulation: koala, nao and yorick can be moved"}});
}

}  // namespace horopter::scenarios
