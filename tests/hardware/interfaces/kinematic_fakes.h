// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>

#include "hardware/interfaces/camera_pair.h"
#include "hardware/interfaces/clock.h"
#include "hardware/interfaces/mobile_base.h"
#include "hardware/interfaces/stereo_head.h"

namespace horopter::hardware {

/// Lifecycle of a fake over a link that can be cut. `Interface` is StereoHead, ...
template <typename Interface>
class KinematicDevice : public Interface {
 public:
  explicit KinematicDevice(Clock& clock) : clock_(clock) {}

  Lifecycle lifecycle() const override { return state_; }

  Result<void> Configure() override {
    if (!linked_) return Error{ErrorCode::kUnavailable, "the link is cut"};
    if (state_ == Lifecycle::kUnconfigured || state_ == Lifecycle::kFault) {
      state_ = Lifecycle::kInactive;
    }
    return {};
  }

  Result<void> Activate() override {
    if (state_ == Lifecycle::kUnconfigured || state_ == Lifecycle::kFault) return NotActive();
    state_ = Lifecycle::kActive;
    return {};
  }

  void Deactivate() override {
    if (state_ != Lifecycle::kActive) return;
    Halt();
    state_ = Lifecycle::kInactive;
  }

  void BreakLink() {
    linked_ = false;
    Halt();
    state_ = Lifecycle::kFault;
  }
  void MendLink() { linked_ = true; }

 protected:
  virtual void Halt() {}

  bool readable() const { return state_ == Lifecycle::kInactive || active(); }
  bool active() const { return state_ == Lifecycle::kActive; }
  Error NotActive() const {
    return {ErrorCode::kNotActive, std::string("the device is ") + ToString(state_)};
  }

  Clock& clock_;

 private:
  Lifecycle state_ = Lifecycle::kUnconfigured;
  bool linked_ = true;
};

/// A two-camera head without a neck: axes that obey their limits, encoders of 0.05 deg.
class KinematicHead final : public KinematicDevice<StereoHead> {
 public:
  static constexpr double kEncoderStep_rad = 0.05 * M_PI / 180;

  using KinematicDevice::KinematicDevice;

  HeadLimits limits() const override {
    const AxisLimits pan{-1.2, 1.0, 3.0, 40.0}, tilt{-0.5, 0.7, 2.0, 30.0};
    return {AxisLimits{}, AxisLimits{}, pan, tilt, pan, tilt};
  }

  Result<HeadReading> Read() override {
    if (!readable()) return NotActive();
    Integrate();
    HeadAxisArray angles{};
    for (int i = 0; i < kHeadAxisCount; ++i) {
      angles[i] = std::round(angle_[i] / kEncoderStep_rad) * kEncoderStep_rad;
    }
    return HeadReading{clock_.Now(), FromArray(angles)};
  }

  Result<void> Command(const HeadAngles& target) override {
    if (!active()) return NotActive();
    const HeadAxisArray wanted = ToArray(target);
    if (!std::all_of(wanted.begin(), wanted.end(), [](double a) { return std::isfinite(a); })) {
      return Error{ErrorCode::kOutOfRange, "a target angle is not finite"};
    }
    Integrate();
    const HeadLimits limit = limits();
    for (int i = 0; i < kHeadAxisCount; ++i) {
      target_[i] = std::clamp(wanted[i], limit[i].min_rad, limit[i].max_rad);
    }
    return {};
  }

 protected:
  void Halt() override {
    Integrate();
    target_ = angle_;
    speed_.fill(0);
  }

 private:
  void Integrate() {
    constexpr Duration kStep = std::chrono::microseconds(500);
    for (; integrated_ + kStep <= clock_.Now(); integrated_ += kStep) {
      for (int i = 0; i < kHeadAxisCount; ++i) Step(i, ToSeconds(kStep));
    }
  }

  /// As fast as the limits allow, braking in time.
  void Step(int i, double dt) {
    const AxisLimits limit = limits()[i];
    if (!limit.exists()) return;
    const double error = target_[i] - angle_[i];
    const double braking = std::sqrt(2 * limit.max_acceleration_rad_s2 * std::abs(error)) * 0.9;
    const double wanted =
        std::copysign(std::min({limit.max_speed_rad_s, braking, std::abs(error) / dt}), error);
    const double change = limit.max_acceleration_rad_s2 * dt;
    const double before = speed_[i];
    speed_[i] += std::clamp(wanted - speed_[i], -change, change);
    angle_[i] += (before + speed_[i]) / 2 * dt;
  }

  HeadAxisArray angle_{}, speed_{}, target_{};
  Time integrated_{};
};

/// Two wheels with limited acceleration and the Koala's encoders.
class KinematicBase final : public KinematicDevice<MobileBase> {
 public:
  static constexpr Duration kDeadman = std::chrono::milliseconds(200);

  using KinematicDevice::KinematicDevice;

  BaseProperties properties() const override { return {45e-6, 0.31, 0.571}; }

  Result<BaseState> Read() override {
    if (!readable()) return NotActive();
    Integrate();
    BaseState state;
    state.t = clock_.Now();
    state.left_pulses = std::llround(travelled_m_[0] / properties().metres_per_pulse);
    state.right_pulses = std::llround(travelled_m_[1] / properties().metres_per_pulse);
    return state;
  }

  Result<void> Command(const WheelSpeeds& speeds) override {
    if (!active()) return NotActive();
    if (!std::isfinite(speeds.left_m_s) || !std::isfinite(speeds.right_m_s)) {
      return Error{ErrorCode::kOutOfRange, "a wheel speed is not finite"};
    }
    Integrate();
    const double fastest = std::max(std::abs(speeds.left_m_s), std::abs(speeds.right_m_s));
    const double scale = std::min(1.0, properties().max_wheel_speed_m_s / std::max(fastest, 1e-9));
    target_m_s_ = {speeds.left_m_s * scale, speeds.right_m_s * scale};
    commanded_ = clock_.Now();
    return {};
  }

 protected:
  void Halt() override {
    Integrate();
    target_m_s_ = {0, 0};
  }

 private:
  void Integrate() {
    constexpr Duration kStep = std::chrono::milliseconds(1);
    constexpr double kAcceleration_m_s2 = 4.0;
    const double dt = ToSeconds(kStep);
    for (; integrated_ + kStep <= clock_.Now(); integrated_ += kStep) {
      if (integrated_ - commanded_ >= kDeadman) target_m_s_ = {0, 0};
      for (int side = 0; side < 2; ++side) {
        const double change = kAcceleration_m_s2 * dt;
        speed_m_s_[side] += std::clamp(target_m_s_[side] - speed_m_s_[side], -change, change);
        travelled_m_[side] += speed_m_s_[side] * dt;
      }
    }
  }

  std::array<double, 2> travelled_m_{}, speed_m_s_{}, target_m_s_{};
  Time integrated_{}, commanded_{};
};

/// Two free-running cameras that show a grey level each, 5 ms late.
class FlatCameras final : public KinematicDevice<CameraPair> {
 public:
  static constexpr Duration kPeriod = std::chrono::milliseconds(40);
  static constexpr Duration kTransfer = std::chrono::milliseconds(5);

  using KinematicDevice::KinematicDevice;

  CameraModel model(Eye eye) const override {
    return CameraModel::FromHorizontalFov(eye == Eye::kLeft ? 64 : 48, 36, 1.0);
  }

  /// Waits for the first frame where there is none yet.
  Result<StereoFrame> Grab() override {
    if (!active()) return NotActive();
    clock_.SleepUntil(Time(kTransfer));
    const std::int64_t index = (clock_.Now().time_since_epoch() - kTransfer) / kPeriod;
    StereoFrame frame;
    frame.sequence = static_cast<std::uint64_t>(index);
    frame.left = Draw(Eye::kLeft, index * kPeriod);
    frame.right = Draw(Eye::kRight, index * kPeriod);
    frame.t_delivered = Time(index * kPeriod + kTransfer);
    return frame;
  }

  void set_grey(std::uint8_t grey) { grey_ = grey; }

 private:
  EyeImage Draw(Eye eye, Duration t) const {
    const CameraModel camera = model(eye);
    return {cv::Mat(camera.height(), camera.width(), CV_8UC3, cv::Scalar::all(grey_)), Time(t)};
  }

  std::uint8_t grey_ = 10;
};

}  // namespace horopter::hardware
