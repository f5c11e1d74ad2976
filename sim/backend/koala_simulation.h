// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "hardware/interfaces/camera_pair.h"
#include "hardware/interfaces/clock.h"
#include "hardware/interfaces/mobile_base.h"
#include "hardware/interfaces/stereo_head.h"
#include "hardware/types/base_state.h"
#include "hardware/types/camera_model.h"
#include "hardware/types/head_angles.h"
#include "hardware/types/stage_times.h"
#include "sim/backend/sim_cameras.h"
#include "sim/backend/sim_clock.h"
#include "sim/backend/sim_head.h"
#include "sim/camera/camera_profile.h"
#include "sim/head/virtual_head.h"
#include "sim/koala/koala_plant.h"
#include "sim/render/renderer.h"
#include "sim/variation/vary.h"
#include "sim/world/world.h"

namespace horopter::sim {

/// A simulated Koala: its scene, its seed, its sensors.
struct KoalaSimulationConfig {
  std::filesystem::path scene;
  std::string scene_text;  ///< MJCF to use in place of the file, as it is; "": the file
  std::uint64_t seed = 1;
  VariationConfig variation;
  /// Bodies to place before the start, by name, in the robot's starting frame.
  std::map<std::string, hardware::Pose> X_OBody;
  hardware::CameraModel camera = hardware::CameraModel::FromHorizontalFov(320, 240, 1.0471975512);
  CameraProfile profile;
  VirtualHeadConfig head;
  KoalaPlantConfig plant;
  hardware::BaseProperties base;  ///< what the base says of itself
  std::string gl_backend = "osmesa";
  bool supersample = false;  ///< RendererOptions::supersample
};

/// The Koala in MuJoCo behind the hardware interfaces, in lockstep: the clock's SleepUntil() is
/// what steps physics.
///
/// Time zero is when the robot has come to rest on its wheels; the starting frame O is the base's
/// planar pose then.
class KoalaSimulation {
 public:
  /// @param times books "physics", "render", "read_back" and "sensor"; outlives the simulation
  /// @throws SceneError, hardware::ConfigError, RenderError
  KoalaSimulation(const KoalaSimulationConfig& config, hardware::StageTimes& times);
  /// The same in a world that is furnished already: of the config, scene and variation do not
  /// count. The head starts where its joints are.
  KoalaSimulation(std::unique_ptr<World> world, const KoalaSimulationConfig& config,
                  hardware::StageTimes& times);
  ~KoalaSimulation();

  hardware::Clock& clock();
  hardware::StereoHead& head();
  hardware::CameraPair& cameras();
  hardware::MobileBase& base();
  std::string gl_renderer() const { return renderer_->gl_renderer(); }

  /// For truth and scoring, which the stack never reaches.
  World& world() { return *world_; }
  const World& world() const { return *world_; }
  const hardware::CameraModel& camera_model() const { return config_.camera; }

  /// What one eye would see now without noise: depth and ids. For a camera without lens distortion
  /// (sim/truth knows the others). @throws hardware::ConfigError
  RenderedView RenderTruth(hardware::Eye eye);

  /// Runs `look` with the world as it was when an eye's newest grabbed image was taken (before the
  /// first Grab(): as it is). The same as now unless the profile has latency, a shutter or skew.
  void AtCapture(hardware::Eye eye, const std::function<void()>& look);

  const hardware::Pose& X_WO() const { return X_WO_; }

  /// Called after every physics step.
  void OnStep(std::function<void(const World&)> observer);

 private:
  class SimBase;

  void Step();
  void Settle();

  KoalaSimulationConfig config_;
  std::unique_ptr<World> world_;
  std::unique_ptr<VirtualHead> head_;
  std::unique_ptr<KoalaPlant> plant_;
  std::unique_ptr<Renderer> renderer_;
  hardware::Pose X_WO_;

  std::unique_ptr<SimClock> clock_device_;
  std::unique_ptr<SimHead> head_device_;
  std::unique_ptr<SimCameras> camera_device_;
  std::unique_ptr<SimBase> base_device_;
};

}  // namespace horopter::sim
