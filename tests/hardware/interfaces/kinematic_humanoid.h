// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "hardware/interfaces/humanoid.h"
#include "tests/hardware/interfaces/kinematic_fakes.h"

namespace horopter::hardware {

/// Glides where it is told, without legs: full speed at once, straight to a target.
class KinematicHumanoid final : public KinematicDevice<Humanoid> {
 public:
  using KinematicDevice::KinematicDevice;

  HumanoidProperties properties() const override {
    return {
        {{"HeadYaw", -2, 2, 8}, {"HeadPitch", -0.6, 0.5, 7}}, {0.1, 0.07, 0.4}, FromSeconds(0.1)};
  }

  Result<HumanoidState> Read() override {
    if (!readable()) return NotActive();
    Integrate();
    return HumanoidState{clock_.Now(), {0, 0}, pose_, walking_};
  }

  Result<void> Move(const WalkVelocity& v) override {
    if (!active()) return NotActive();
    if (!std::isfinite(v.forward_m_s + v.left_m_s + v.turn_rad_s)) return NotFinite();
    Integrate();
    const WalkVelocity most = properties().max_velocity;
    const double excess =
        std::max({1.0, std::abs(v.forward_m_s) / most.forward_m_s,
                  std::abs(v.left_m_s) / most.left_m_s, std::abs(v.turn_rad_s) / most.turn_rad_s});
    velocity_ = {v.forward_m_s / excess, v.left_m_s / excess, v.turn_rad_s / excess};
    walking_ = v.forward_m_s != 0 || v.left_m_s != 0 || v.turn_rad_s != 0;
    targeted_ = false;
    return {};
  }

  Result<void> MoveTo(const Pose2& target) override {
    if (!active()) return NotActive();
    if (!std::isfinite(target.x_m + target.y_m + target.heading_rad)) return NotFinite();
    Integrate();
    target_ = Compose(pose_, target);
    targeted_ = walking_ = true;
    return {};
  }

  Result<void> Stop() override {
    if (!active()) return NotActive();
    Halt();
    return {};
  }

 protected:
  void Halt() override {
    Integrate();
    velocity_ = {};
    targeted_ = walking_ = false;
  }

 private:
  static Error NotFinite() { return {ErrorCode::kOutOfRange, "a component is not finite"}; }
  static Pose2 Compose(const Pose2& a, const Pose2& b) { return ToPose2(ToPose(a) * ToPose(b)); }

  void Integrate() {
    constexpr Duration kStep = std::chrono::milliseconds(1);
    const double dt = ToSeconds(kStep);
    for (; integrated_ + kStep <= clock_.Now(); integrated_ += kStep) {
      if (targeted_) {
        Approach(dt);
      } else {
        pose_ = Compose(pose_, {velocity_.forward_m_s * dt, velocity_.left_m_s * dt,
                                velocity_.turn_rad_s * dt});
      }
    }
  }

  void Approach(double dt) {
    const double dx = target_.x_m - pose_.x_m, dy = target_.y_m - pose_.y_m;
    const double turn = WrapAngle(target_.heading_rad - pose_.heading_rad);
    const WalkVelocity most = properties().max_velocity;
    const double time =
        std::max(std::hypot(dx, dy) / most.left_m_s, std::abs(turn) / most.turn_rad_s);
    const double share = time <= dt ? 1 : dt / time;
    pose_ = {pose_.x_m + share * dx, pose_.y_m + share * dy, pose_.heading_rad + share * turn};
    if (share == 1) targeted_ = walking_ = false;
    if (!targeted_) velocity_ = {};
  }

  Pose2 pose_, target_;
  WalkVelocity velocity_;
  bool targeted_ = false;
  bool walking_ = false;
  Time integrated_{};
};

}  // namespace horopter::hardware
