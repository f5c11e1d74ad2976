// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hardware/interfaces/clock.h"
#include "hardware/interfaces/humanoid.h"
#include "sim/backend/sim_device.h"
#include "sim/nao/nao_plant.h"

namespace horopter::sim {

/// A NaoPlant behind the hardware interface.
class SimHumanoid final : public SimDevice<hardware::Humanoid> {
 public:
  /// @param plant outlives the device, as does `clock`
  SimHumanoid(NaoPlant& plant, const hardware::Clock& clock) : plant_(plant), clock_(clock) {}

  hardware::Result<hardware::HumanoidState> Read() override;
  hardware::Result<void> Move(const hardware::WalkVelocity& velocity) override;
  hardware::Result<void> MoveTo(const hardware::Pose2& target) override;
  hardware::Result<void> Stop() override;
  hardware::HumanoidProperties properties() const override;

 private:
  /// Active, every component finite, and on its feet.
  hardware::Result<void> MayWalk(const char* call, double a, double b, double c) const;
  void StopMotion() override { plant_.Stop(); }
  void OnFirstConfigure() override { plant_.ResetOdometry(); }

  NaoPlant& plant_;
  const hardware::Clock& clock_;
};

}  // namespace horopter::sim
