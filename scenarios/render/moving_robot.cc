// SPDX-License-Identifier: Apache-2.0
#include "scenarios/render/moving_robot.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>
#include <variant>
#include <vector>

#include "control/base/unicycle.h"
#include "hardware/types/config_error.h"
#include "scenarios/format/fault_config.h"
#include "scenarios/render/camera_models.h"
#include "scenarios/render/request_checks.h"
#include "scenarios/runner/koala_plant_config.h"
#include "sim/backend/koala_simulation.h"
#include "sim/backend/nao_simulation.h"
#include "sim/backend/yorick_simulation.h"
#include "sim/faults/faulty_cameras.h"
#include "sim/faults/mount_faults.h"

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
  config.head.faults = FaultsOf(request.faults);
  return config;
}

/// A pair of cameras as it is mounted and as its cables bring its frames: what faults of those make
/// of it.
class FaultyPair {
 public:
  FaultyPair(sim::World& world, hardware::CameraPair& cameras,
             const std::vector<sim::Fault>& faults, const CameraPairDescription& names)
      : mounts_(world, faults, {names.left, names.right}), cameras_(cameras, faults) {
    Start(cameras_);
  }

  hardware::CameraPair& cameras() { return cameras_; }
  void Mount(hardware::Time t) { mounts_.Update(t); }

 private:
  sim::MountFaults mounts_;
  sim::FaultyCameras cameras_;
};

/// What the three simulations do alike.
template <typename Simulation>
class Simulated : public MovingRobot {
 public:
  template <typename Config>
  Simulated(std::unique_ptr<sim::World> world, const Config& config, hardware::StageTimes& times)
      : simulation_(std::move(world), config, times) {
    Start(simulation_.head());
    simulation_.OnStep([this](const sim::World&) { Mount(); });
  }

  hardware::Clock& clock() override { return simulation_.clock(); }
  hardware::StereoHead& head() override { return simulation_.head(); }
  sim::World& world() override { return simulation_.world(); }
  std::string gl_renderer() const override { return simulation_.gl_renderer(); }
  void OnStep(std::function<void(const sim::World&)> observer) override {
    simulation_.OnStep(std::move(observer));
  }

 protected:
  void Mount() {
    for (const auto& [name, pair] : pairs_) pair->Mount(simulation_.clock().Now());
  }

  Simulation simulation_;
  std::map<std::string, std::unique_ptr<FaultyPair>> pairs_;  ///< by name
};

/// A robot with one pair of cameras.
template <typename Simulation>
class OnePair : public Simulated<Simulation> {
 public:
  template <typename Config>
  OnePair(std::unique_ptr<sim::World> world, const Config& config,
          const CameraPairDescription& names, hardware::StageTimes& times)
      : Simulated<Simulation>(std::move(world), config, times) {
    this->pairs_[""] = std::make_unique<FaultyPair>(this->world(), this->simulation_.cameras(),
                                                    config.head.faults, names);
    this->Mount();
  }

  hardware::CameraPair& cameras(const std::string&) override {
    return this->pairs_.at("")->cameras();
  }
  hardware::Pose X_WO() const override { return this->simulation_.X_WO(); }
  void AtCapture(const std::string&, Eye eye, const std::function<void()>& look) override {
    this->simulation_.AtCapture(eye, look);
  }
};

class Koala final : public OnePair<sim::KoalaSimulation> {
 public:
  Koala(std::unique_ptr<sim::World> world, const sim::KoalaSimulationConfig& config,
        const CameraPairDescription& names, hardware::StageTimes& times)
      : OnePair(std::move(world), config, names, times) {
    Start(simulation_.base());
  }

  void Give(const MotionCommand& command) override {
    const auto& drive = std::get<DriveCommand>(command.what);
    hardware::MobileBase& base = simulation_.base();
    Require(base.Command(
        control::FromTwist({drive.forward_m_s, drive.turn_deg_s * kRadians}, base.properties())));
  }
};

class Nao final : public OnePair<sim::NaoSimulation> {
 public:
  Nao(std::unique_ptr<sim::World> world, const sim::NaoSimulationConfig& config,
      const CameraPairDescription& names, hardware::StageTimes& times)
      : OnePair(std::move(world), config, names, times) {
    Start(simulation_.humanoid());
  }

  void Give(const MotionCommand& command) override {
    hardware::Humanoid& legs = simulation_.humanoid();
    if (const auto* target = std::get_if<WalkToCommand>(&command.what)) {
      Require(legs.MoveTo({target->x_m, target->y_m, target->turn_deg * kRadians}));
    } else {
      const auto& walk = std::get<WalkCommand>(command.what);
      Require(legs.Move({walk.forward_m_s, walk.left_m_s, walk.turn_deg_s * kRadians}));
    }
  }
};

class Yorick final : public Simulated<sim::YorickSimulation> {
 public:
  Yorick(std::unique_ptr<sim::World> world, const sim::YorickSimulationConfig& config,
         const RobotDescription& robot, const hardware::Pose& X_WO, hardware::StageTimes& times)
      : Simulated(std::move(world), config, times), X_WO_(X_WO) {
    for (const char* name : {"peripheral", "foveal"}) {
      pairs_[name] =
          std::make_unique<FaultyPair>(Simulated::world(), simulation_.cameras(PairOf(name)),
                                       config.head.faults, robot.Cameras(name));
    }
    Mount();
  }

  void Give(const MotionCommand&) override { throw std::logic_error("no legs, no wheels"); }
  hardware::CameraPair& cameras(const std::string& pair) override {
    const auto found = pairs_.find(pair);
    if (found == pairs_.end()) throw std::invalid_argument("yorick has no cameras " + pair);
    return found->second->cameras();
  }
  hardware::Pose X_WO() const override { return X_WO_; }
  void AtCapture(const std::string& pair, Eye eye, const std::function<void()>& look) override {
    simulation_.AtCapture(PairOf(pair), eye, look);
  }

 private:
  static YorickPair PairOf(const std::string& pair) {
    if (pair == "peripheral") return YorickPair::kPeripheral;
    if (pair == "foveal") return YorickPair::kFoveal;
    throw std::invalid_argument("yorick has no cameras " + pair);
  }

  hardware::Pose X_WO_;
};

}  // namespace

std::unique_ptr<MovingRobot> MakeMovingRobot(const RenderRequest& request,
                                             const RobotDescription& robot,
                                             std::unique_ptr<sim::World> world,
                                             const hardware::Pose& X_WO,
                                             hardware::StageTimes& times) {
  const auto camera = [&](const std::string& pair) {
    return CameraModelOf(request.camera, robot.Cameras(pair));
  };
  const std::string first = PairNames(request, robot).front();
  if (robot.name == "koala") {
    auto config = CommonConfig<sim::KoalaSimulationConfig>(request, robot);
    config.camera = camera(first);
    config.base = robot.wheels.value().properties;
    config.plant = KoalaPlantConfigOf(*robot.wheels);
    return std::make_unique<Koala>(std::move(world), config, robot.Cameras(first), times);
  }
  if (robot.name == "nao") {
    auto config = CommonConfig<sim::NaoSimulationConfig>(request, robot);
    config.camera = camera(first);
    return std::make_unique<Nao>(std::move(world), config, robot.Cameras(first), times);
  }
  if (robot.name == "yorick") {
    auto config = CommonConfig<sim::YorickSimulationConfig>(request, robot);
    config.peripheral = camera("peripheral");
    config.foveal = camera("foveal");
    return std::make_unique<Yorick>(std::move(world), config, robot, X_WO, times);
  }
  throw hardware::ConfigError(
      {{"--robot", robot.name, "has no simulation: koala, nao and yorick can be moved"}});
}

}  // namespace horopter::scenarios
