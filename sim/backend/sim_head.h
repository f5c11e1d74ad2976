// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hardware/interfaces/clock.h"
#include "hardware/interfaces/stereo_head.h"
#include "sim/backend/sim_device.h"
#include "sim/head/virtual_head.h"

namespace horopter::sim {

/// A VirtualHead behind the hardware interface.
class SimHead final : public SimDevice<hardware::StereoHead> {
 public:
  /// @param head outlives the device, as does `clock`
  SimHead(VirtualHead& head, const hardware::Clock& clock) : head_(head), clock_(clock) {}

  hardware::Result<hardware::HeadReading> Read() override;
  hardware::Result<void> Command(const hardware::HeadAngles& target) override;
  hardware::HeadLimits limits() const override { return head_.limits(); }

 private:
  void StopMotion() override { head_.Command(head_.SetPoint()); }

  VirtualHead& head_;
  const hardware::Clock& clock_;
};

}  // namespace horopter::sim
