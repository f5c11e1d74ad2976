// SPDX-License-Identifier: Apache-2.0
#include "scenarios/runner/backend.h"

#include <cmath>

#include "scenarios/format/scenes.h"
#include "scenarios/runner/koala_truth.h"
#include "sim/backend/koala_simulation.h"

namespace horopter::scenarios {
namespace {

constexpr double kRadians = M_PI / 180;

sim::KoalaSimulationConfig ConfigOf(const Scenario& scenario, const RobotDescription& robot) {
  sim::KoalaSimulationConfig config;
  config.scene = ScenesDir() / scenario.scene;
  config.seed = scenario.seed;
  config.variation = {scenario.variation.obstacles_m, scenario.variation.heading_deg * kRadians,
                      scenario.variation.textures};
  for (const auto& [body, placement] : scenario.bodies) {
    hardware::Pose X_OBody = hardware::ToPose({0, 0, placement.yaw_deg * kRadians});
    X_OBody.translation() = placement.position_m;
    config.X_OBody[body] = X_OBody;
  }
  config.camera = hardware::CameraModel::FromHorizontalFov(
      scenario.camera.width, scenario.camera.height, scenario.camera.horizontal_fov_deg * kRadians);
  config.profile.noise = sim::CameraProfile::Named(scenario.camera.sensor).noise;
  config.head = {robot.head_limits, scenario.head.encoder_step_deg * kRadians,
                 scenario.head.encoder_noise_deg * kRadians, scenario.seed};
  const WheelsDescription& wheels = robot.wheels.value();
  config.base = wheels.properties;
  config.plant.metres_per_pulse = wheels.properties.metres_per_pulse;
  config.plant.pulses_per_turn = wheels.pulses_per_turn;
  config.plant.max_wheel_speed_m_s = wheels.properties.max_wheel_speed_m_s;
  config.plant.max_wheel_acceleration_m_s2 = wheels.max_acceleration_m_s2;
  config.plant.deadman = hardware::FromSeconds(wheels.deadman_s);
  return config;
}

class SimBackend final : public Backend {
 public:
  SimBackend(const Scenario& scenario, const RobotDescription& robot, hardware::StageTimes& times)
      : simulation_(ConfigOf(scenario, robot), times), truth_(simulation_, times) {}

  hardware::Clock& clock() override { return simulation_.clock(); }
  hardware::StereoHead& head() override { return simulation_.head(); }
  hardware::CameraPair& cameras() override { return simulation_.cameras(); }
  hardware::MobileBase& base() override { return simulation_.base(); }
  TruthProbe* truth() override { return &truth_; }
  std::string gl_renderer() const override { return simulation_.gl_renderer(); }

 private:
  sim::KoalaSimulation simulation_;
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
