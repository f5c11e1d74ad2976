// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "hardware/types/eye.h"
#include "hardware/types/time.h"
#include "sim/faults/fault.h"
#include "sim/world/world.h"

namespace horopter::sim {

/// Eyes that stand elsewhere, or otherwise, than the head's description says: a wrong baseline,
/// cameras that sit crooked.
///
/// They are moved in the world itself, so that images and truth show them where they are. Of a head
/// with several pairs each has its own MountFaults, all made before any is updated. Baseline errors
/// move what carries an eye: the outermost body that carries it and not the other one, or the
/// camera where both sit on one body.
class MountFaults {
 public:
  /// Takes those of `faults` that concern the mounting; `world` must outlive this.
  /// @pre Validate(faults) is empty
  /// @param cameras of the pair, by their names in the scene
  /// @throws SceneError when such a fault is given and the scene lacks one of the cameras
  /// @throws hardware::ConfigError when a baseline error would bring the eyes together
  MountFaults(World& world, const std::vector<Fault>& faults,
              hardware::PerEye<std::string> cameras = {"left", "right"});

  bool none() const { return baselines_.empty() && misaligned_.empty(); }

  /// Puts the eyes where the faults of this time have them; nothing happens while none begins or
  /// ends, else the world's derived quantities are computed anew (World::Forward).
  void Update(hardware::Time t);

 private:
  template <typename What>
  struct Timed {
    What what;
    TimeWindow when;
    bool active = false;
  };
  /// What carries an eye: a body, or the camera itself.
  struct Mount {
    int body = -1;
    int camera = -1;
    Eigen::Vector3d sound_position =
        Eigen::Vector3d::Zero();  ///< in the frame of what carries both
    Eigen::Quaterniond sound_camera = Eigen::Quaterniond::Identity();
  };

  void FindMounts();
  void RequireApart() const;
  void Place(hardware::Eye eye);
  double BaselineError() const;

  World& world_;
  hardware::PerEye<std::string> cameras_;
  std::vector<Timed<WrongBaseline>> baselines_;
  std::vector<Timed<MisalignedEye>> misaligned_;
  hardware::PerEye<Mount> mounts_;
};

}  // namespace horopter::sim
