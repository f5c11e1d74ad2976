// SPDX-License-Identifier: Apache-2.0
#include "scenarios/runner/backend.h"

#include <cmath>
#include <optional>

#include "scenarios/format/fault_config.h"
#include "scenarios/format/scenes.h"
#include "scenarios/runner/koala_plant_config.h"
#include "scenarios/runner/koala_truth.h"
#include "scenarios/runner/room_setup.h"
#include "sim/backend/koala_simulation.h"
#include "sim/faults/faulty_cameras.h"
#include "sim/faults/mount_faults.h"

namespace horopter::scenarios {
namespace {

constexpr double kRadians = M_PI / 180;

sim::VariationConfig VariationOf(const Scenario& scenario) {
  return {scenario.variation.obstacles_m, scenario.variation.heading_deg * kRadians,
          scenario.variation.textures};
}

std::optional<sim::Room> RoomOf(const Scenario& scenario) {
  if (!scenario.room) return std::nullopt;
  return MakeRoom(scenario, VariationOf(scenario));
}

sim::KoalaSimulationConfig ConfigOf(const Scenario& scenario, const RobotDescription& robot,
                                    const std::optional<sim::Room>& room) {
  sim::KoalaSimulationConfig config;
  config.scene = ScenesDir() / scenario.scene;
  config.seed = scenario.seed;
  config.variation = VariationOf(scenario);
  if (room) {
    config.scene_text = room->mjcf;
    config.variation.obstacle_shift_m = 0;  // the seed has placed them
  }
  for (const auto& [body, placement] : scenario.bodies) {
    config.X_OBody[body] = placement.X_OBody();
  }
  const CameraSpec& camera = scenario.camera;
  config.camera =
      camera.profile.lens.Model(camera.width, camera.height, camera.horizontal_fov_deg * kRadians);
  config.profile = camera.profile;
  config.gl_backend = scenario.gl;
  config.head = {robot.head_limits, scenario.head.encoder_step_deg * kRadians,
                 scenario.head.encoder_noise_deg * kRadians, scenario.seed,
                 FaultsOf(scenario.faults)};
  const WheelsDescription& wheels = robot.wheels.value();
  config.base = wheels.properties;
  config.plant = KoalaPlantConfigOf(wheels);
  return config;
}

class SimBackend final : public Backend {
 public:
  SimBackend(const Scenario& scenario, const RobotDescription& robot, hardware::StageTimes& times)
      : room_(RoomOf(scenario)),
        simulation_(ConfigOf(scenario, robot, room_), times),
        mounts_(simulation_.world(), FaultsOf(scenario.faults)),
        cameras_(simulation_.cameras(), FaultsOf(scenario.faults)),
        truth_(simulation_, times) {
    mounts_.Update(simulation_.clock().Now());
    simulation_.OnStep([this](const sim::World&) { mounts_.Update(simulation_.clock().Now()); });
  }

  hardware::Clock& clock() override { return simulation_.clock(); }
  hardware::StereoHead& head() override { return simulation_.head(); }
  hardware::CameraPair& cameras() override { return cameras_; }
  hardware::MobileBase& base() override { return simulation_.base(); }
  TruthProbe* truth() override { return &truth_; }
  std::string gl_renderer() const override { return simulation_.gl_renderer(); }
  std::map<std::string, std::string> records() const override {
    if (!room_) return {};
    return {{"room.json", RoomText(*room_)}, {"room.xml", room_->mjcf}};
  }

 private:
  std::optional<sim::Room> room_;
  sim::KoalaSimulation simulation_;
  sim::MountFaults mounts_;
  sim::FaultyCameras cameras_;
  KoalaTruth truth_;
};

}  // namespace

std::unique_ptr<Backend> CreateBackend(const Scenario& scenario, const RobotDescription& robot,
                                       hardware::StageTimes& times) {
  if (scenario.backend == "sim") return std::make_unique<SimBackend>(scenario, robot, times);
  throw BackendUnavailable("backend '" + scenario.backend +
                           "' is not available in this build; run with --backend sim, and see "
                           "`horopter doctor` for what each backend needs");
}

}  // namespace horopter::scenarios
