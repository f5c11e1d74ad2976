// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "hardware/interfaces/camera_pair.h"
#include "hardware/interfaces/clock.h"
#include "hardware/interfaces/humanoid.h"
#include "hardware/interfaces/stereo_head.h"
#include "hardware/types/camera_model.h"
#include "hardware/types/eye.h"
#include "hardware/types/pose.h"
#include "hardware/types/stage_times.h"
#include "sim/backend/sim_cameras.h"
#include "sim/backend/sim_clock.h"
#include "sim/backend/sim_head.h"
#include "sim/backend/sim_humanoid.h"
#include "sim/camera/camera_profile.h"
#include "sim/head/virtual_head.h"
#include "sim/nao/head_limits.h"
#include "sim/nao/nao_cameras.h"
#include "sim/nao/nao_plant.h"
#include "sim/render/renderer.h"
#include "sim/variation/vary.h"
#include "sim/world/world.h"

namespace horopter::sim {

/// NAO's head in a scene: its limits, and encoders of 12 bits a turn.
inline VirtualHeadConfig NaoVirtualHead() {
  VirtualHeadConfig head;
  head.limits = NaoHeadLimits();
  head.encoder_resolution_rad = 2 * M_PI / 4096;
  return head;
}

/// A simulated NAO: its scene, its seed, its sensors.
struct NaoSimulationConfig {
  std::filesystem::path scene;
  std::uint64_t seed = 1;  ///< of textures, sensors and the feet's slip
  VariationConfig variation;
  /// Bodies to place before the start, by name, in the robot's starting frame.
  std::map<std::string, hardware::Pose> X_OBody;
  hardware::CameraModel camera = NaoCamera(NaoLens::kWide);  ///< of either eye
  CameraProfile profile;
  VirtualHeadConfig head = NaoVirtualHead();
  NaoGaitConfig gait;
  std::string gl_backend = "osmesa";
  bool supersample = false;  ///< RendererOptions::supersample
};

/// NAO in MuJoCo behind the hardware interfaces, in lockstep: the clock's SleepUntil() is what
/// steps physics. Its head is the StereoHead's neck (yaw as pan, pitch as tilt); the webcams on its
/// front plate, left_eye and right_eye in the scene, are the camera pair.
///
/// Time zero is when the robot has come to rest on its feet; the starting frame O is the base's
/// planar pose then.
class NaoSimulation {
 public:
  /// @param times books "physics", "render", "read_back" and "sensor"; outlives the simulation
  /// @throws SceneError, hardware::ConfigError, RenderError
  NaoSimulation(const NaoSimulationConfig& config, hardware::StageTimes& times);
  /// The same in a world that is furnished already: of the config, scene and variation do not
  /// count. The head starts where its joints are.
  NaoSimulation(std::unique_ptr<World> world, const NaoSimulationConfig& config,
                hardware::StageTimes& times);
  ~NaoSimulation();

  hardware::Clock& clock() { return *clock_device_; }
  hardware::StereoHead& head() { return *head_device_; }
  hardware::CameraPair& cameras() { return *camera_device_; }
  hardware::Humanoid& humanoid() { return *humanoid_device_; }
  std::string gl_renderer() const { return renderer_->gl_renderer(); }

  /// For truth and scoring, which the stack never reaches.
  World& world() { return *world_; }
  const World& world() const { return *world_; }
  const NaoPlant& plant() const { return *plant_; }
  const hardware::CameraModel& camera_model() const { return config_.camera; }
  /// Name of an eye's camera in the scene.
  static std::string CameraName(hardware::Eye eye) { return std::string(ToString(eye)) + "_eye"; }

  /// What one eye would see now without noise: depth and ids.
  RenderedView RenderTruth(hardware::Eye eye);

  /// Runs `look` with the world as it was when an eye's newest grabbed image was taken (before the
  /// first Grab(): as it is). The same as now unless the profile has latency, a shutter or skew.
  void AtCapture(hardware::Eye eye, const std::function<void()>& look);

  const hardware::Pose& X_WO() const { return X_WO_; }

  /// Called after every physics step.
  void OnStep(std::function<void(const World&)> observer) {
    clock_device_->OnStep(std::move(observer));
  }

 private:
  void MakeRobot();
  void MakeDevices(hardware::StageTimes& times);
  void Step();

  NaoSimulationConfig config_;
  std::unique_ptr<World> world_;
  std::unique_ptr<VirtualHead> head_;
  std::unique_ptr<NaoPlant> plant_;
  std::unique_ptr<Renderer> renderer_;
  hardware::Pose X_WO_;

  std::unique_ptr<SimClock> clock_device_;
  std::unique_ptr<SimHead> head_device_;
  std::unique_ptr<SimCameras> camera_device_;
  std::unique_ptr<SimHumanoid> humanoid_device_;
};

}  // namespace horopter::sim
