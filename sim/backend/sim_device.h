// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "hardware/interfaces/device.h"

namespace horopter::sim {

/// The lifecycle that all simulated devices share (hardware/interfaces/device.h). There is no link
/// to lose here, so there is no way into fault.
template <typename Interface>
class SimDevice : public Interface {
 public:
  hardware::Lifecycle lifecycle() const final { return lifecycle_; }

  hardware::Result<void> Configure() final {
    if (lifecycle_ != hardware::Lifecycle::kActive) lifecycle_ = hardware::Lifecycle::kInactive;
    if (!was_configured_) OnFirstConfigure();
    was_configured_ = true;
    return {};
  }

  hardware::Result<void> Activate() final {
    if (auto allowed = Require("Activate", true); !allowed.ok()) return allowed;
    lifecycle_ = hardware::Lifecycle::kActive;
    return {};
  }

  void Deactivate() final {
    if (lifecycle_ != hardware::Lifecycle::kActive) return;
    StopMotion();
    lifecycle_ = hardware::Lifecycle::kInactive;
  }

 protected:
  /// kNotActive unless active, or inactive where that is enough.
  hardware::Result<void> Require(std::string_view call, bool inactive_is_enough) const {
    const bool allowed = lifecycle_ == hardware::Lifecycle::kActive ||
                         (inactive_is_enough && lifecycle_ == hardware::Lifecycle::kInactive);
    if (allowed) return {};
    return hardware::Error{hardware::ErrorCode::kNotActive,
                           std::string(call) + " is not allowed while the device is " +
                               ToString(lifecycle_) +
                               (inactive_is_enough ? "; Configure() it first"
                                                   : "; Configure() and Activate() it first")};
  }

 private:
  virtual void StopMotion() {}
  virtual void OnFirstConfigure() {}

  hardware::Lifecycle lifecycle_ = hardware::Lifecycle::kUnconfigured;
  bool was_configured_ = false;
};

}  // namespace horopter::sim
