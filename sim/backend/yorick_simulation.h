// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "hardware/interfaces/camera_pair.h"
#include "hardware/interfaces/clock.h"
#include "hardware/interfaces/stereo_head.h"
#include "hardware/types/camera_model.h"
#include "hardware/types/eye.h"
#include "hardware/types/pose.h"
#include "hardware/types/stage_times.h"
#include "sim/backend/sim_cameras.h"
#include "sim/backend/sim_clock.h"
#include "sim/backend/sim_head.h"
#include "sim/camera/camera_profile.h"
#include "sim/head/virtual_head.h"
#include "sim/render/renderer.h"
#include "sim/tabletop/arrange_tabletop.h"
#include "sim/world/world.h"

namespace horopter::sim {

/// The two pairs of cameras on one head.
enum class YorickPair { kPeripheral, kFoveal };

/// A simulated Yorick: its scene, its seed, its sensors.
struct YorickSimulationConfig {
  std::filesystem::path scene;
  std::uint64_t seed = 1;
  /// What is on the table; nothing: what the scene file says, and textures by the seed.
  std::optional<TabletopConfig> tabletop = TabletopConfig{};
  /// Bodies to place before the start, by name, in the base frame; after the arrangement.
  std::map<std::string, hardware::Pose> X_BBody;
  /// Of either eye: Sony XC999 as PAL has them, with the fields of view of the paper.
  hardware::CameraModel peripheral =
      hardware::CameraModel::FromHorizontalFov(768, 576, 60 * M_PI / 180);
  hardware::CameraModel foveal =
      hardware::CameraModel::FromHorizontalFov(768, 576, 14 * M_PI / 180);
  CameraProfile profile;  ///< of all four cameras
  VirtualHeadConfig head;
  std::string gl_backend = "osmesa";
  bool supersample = false;  ///< RendererOptions::supersample
};

/// Yorick in MuJoCo behind the hardware interfaces, in lockstep: the clock's SleepUntil() is what
/// steps physics. It stands still, so that W and its base frame B keep their place to each other.
///
/// The scene's cameras are left_peripheral, right_peripheral, left_fovea and right_fovea.
class YorickSimulation {
 public:
  /// @param times books "physics", "render", "read_back" and "sensor"; outlives the simulation
  /// @throws SceneError, hardware::ConfigError, RenderError
  YorickSimulation(const YorickSimulationConfig& config, hardware::StageTimes& times);
  /// The same in a world that is furnished already: of the config, scene, tabletop and bodies do
  /// not count. The head starts where its joints are.
  YorickSimulation(std::unique_ptr<World> world, const YorickSimulationConfig& config,
                   hardware::StageTimes& times);
  ~YorickSimulation();

  hardware::Clock& clock();
  hardware::StereoHead& head();
  hardware::CameraPair& cameras(YorickPair pair);
  std::string gl_renderer() const { return renderer_->gl_renderer(); }

  /// For truth and scoring, which the stack never reaches.
  World& world() { return *world_; }
  const World& world() const { return *world_; }
  const hardware::CameraModel& camera_model(YorickPair pair) const;
  /// Name of an eye's camera in the scene.
  static std::string CameraName(YorickPair pair, hardware::Eye eye);
  /// How the table was arranged; nothing when the scene file did it.
  const std::optional<Tabletop>& tabletop() const { return tabletop_; }
  hardware::Pose X_WB() const { return world_->X_WBody("base"); }

  /// What one eye of a pair would see now without noise: depth and ids.
  RenderedView RenderTruth(YorickPair pair, hardware::Eye eye);

  /// Runs `look` with the world as it was when an eye of a pair took its newest
  /// grabbed image (before the first Grab(): as it is). The same as now unless the profile has
  /// latency, a shutter or skew.
  void AtCapture(YorickPair pair, hardware::Eye eye, const std::function<void()>& look);

  /// Called after every physics step.
  void OnStep(std::function<void(const World&)> observer);

 private:
  void Furnish();
  void MakeDevices(hardware::StageTimes& times);
  void Step();

  YorickSimulationConfig config_;
  std::unique_ptr<World> world_;
  std::optional<Tabletop> tabletop_;
  std::unique_ptr<VirtualHead> head_;
  std::unique_ptr<Renderer> renderer_;

  std::unique_ptr<SimClock> clock_device_;
  std::unique_ptr<SimHead> head_device_;
  std::unique_ptr<SimCameras> peripheral_device_;
  std::unique_ptr<SimCameras> foveal_device_;
};

}  // namespace horopter::sim
