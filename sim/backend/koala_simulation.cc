// SPDX-License-Identifier: Apache-2.0
#include "sim/backend/koala_simulation.h"

#include <cmath>
#include <utility>

#include "sim/backend/sim_device.h"

namespace horopter::sim {
namespace {

using hardware::Duration;
using hardware::Error;
using hardware::ErrorCode;
using hardware::Eye;
using hardware::Result;
using hardware::Time;

/// Long enough for the wheels to take up the robot's weight and for the body to stop swinging.
constexpr Duration kSettleTime = std::chrono::milliseconds(400);

}  // namespace

class KoalaSimulation::SimClock final : public hardware::Clock {
 public:
  explicit SimClock(KoalaSimulation& sim) : sim_(sim) {}

  Time Now() const override { return sim_.world_->now() - sim_.settled_; }

  void SleepUntil(Time t) override {
    if (Now() >= t) return;
    sim_.times_.Measure("physics", [&] {
      while (Now() < t) sim_.Step();
    });
  }

 private:
  KoalaSimulation& sim_;
};

class KoalaSimulation::SimHead final : public SimDevice<hardware::StereoHead> {
 public:
  explicit SimHead(KoalaSimulation& sim) : sim_(sim) {}

  Result<hardware::HeadReading> Read() override {
    if (const auto allowed = Require("Read", true); !allowed.ok()) return allowed.error();
    return hardware::HeadReading{sim_.clock_device_->Now(), sim_.head_->ReadEncoders()};
  }

  Result<void> Command(const hardware::HeadAngles& target) override {
    if (const auto allowed = Require("Command", false); !allowed.ok()) return allowed;
    for (const double angle : hardware::ToArray(target)) {
      if (!std::isfinite(angle)) {
        return Error{ErrorCode::kOutOfRange, "head command: every angle must be finite"};
      }
    }
    sim_.head_->Command(target);
    return {};
  }

  hardware::HeadLimits limits() const override { return sim_.head_->limits(); }

 private:
  void StopMotion() override { sim_.head_->Command(sim_.head_->SetPoint()); }

  KoalaSimulation& sim_;
};

class KoalaSimulation::SimCameras final : public SimDevice<hardware::CameraPair> {
 public:
  explicit SimCameras(KoalaSimulation& sim)
      : sim_(sim),
        sensor_{SensorModel(sim.config_.sensor, sim.config_.seed, Eye::kLeft),
                SensorModel(sim.config_.sensor, sim.config_.seed, Eye::kRight)} {}

  hardware::CameraModel model(Eye) const override { return sim_.config_.camera; }

  Result<hardware::StereoFrame> Grab() override {
    if (const auto allowed = Require("Grab", false); !allowed.ok()) return allowed.error();
    hardware::StereoFrame frame;
    frame.sequence = sequence_++;
    frame.t_delivered = sim_.clock_device_->Now();
    frame.left = See(Eye::kLeft, frame);
    frame.right = See(Eye::kRight, frame);
    return frame;
  }

 private:
  hardware::EyeImage See(Eye eye, const hardware::StereoFrame& frame) {
    const hardware::Pose X_WC = sim_.world_->X_WCamera(ToString(eye));
    cv::Mat bgr = sim_.renderer_->Render(X_WC, sim_.config_.camera, {}, &sim_.times_).bgr;
    const SensorModel& sensor = eye == Eye::kLeft ? sensor_[0] : sensor_[1];
    sim_.times_.Measure("sensor", [&] { sensor.Apply(frame.sequence, bgr); });
    return {bgr, frame.t_delivered};
  }

  KoalaSimulation& sim_;
  SensorModel sensor_[2];
  std::uint64_t sequence_ = 0;
};

class KoalaSimulation::SimBase final : public SimDevice<hardware::MobileBase> {
 public:
  explicit SimBase(KoalaSimulation& sim) : sim_(sim) {}

  Result<hardware::BaseState> Read() override {
    if (const auto allowed = Require("Read", true); !allowed.ok()) return allowed.error();
    const WheelPulses pulses = sim_.plant_->Encoders();
    const auto proximity = sim_.plant_->Proximity();
    return hardware::BaseState{
        sim_.clock_device_->Now(), pulses.left, pulses.right, {proximity.begin(), proximity.end()}};
  }

  Result<void> Command(const hardware::WheelSpeeds& speeds) override {
    if (const auto allowed = Require("Command", false); !allowed.ok()) return allowed;
    if (!std::isfinite(speeds.left_m_s) || !std::isfinite(speeds.right_m_s)) {
      return Error{ErrorCode::kOutOfRange, "base command: both wheel speeds must be finite"};
    }
    sim_.plant_->Command(speeds);
    return {};
  }

  hardware::BaseProperties properties() const override { return sim_.config_.base; }

 private:
  void StopMotion() override { sim_.plant_->Command({0, 0}); }
  void OnFirstConfigure() override { sim_.plant_->SetEncoders({}); }

  KoalaSimulation& sim_;
};

KoalaSimulation::KoalaSimulation(const KoalaSimulationConfig& config, hardware::StageTimes& times)
    : config_(config), times_(times), world_(std::make_unique<World>(config.scene)) {
  Vary(*world_, config.variation, config.seed);
  head_ = std::make_unique<VirtualHead>(*world_, config.head);
  plant_ = std::make_unique<KoalaPlant>(*world_, config.plant);
  Settle();
  for (const auto& [body, X_OBody] : config.X_OBody) world_->PlaceBody(body, X_WO_ * X_OBody);
  RendererOptions options;
  options.gl_backend = config.gl_backend;
  options.width = config.camera.width();
  options.height = config.camera.height();
  renderer_ = std::make_unique<Renderer>(*world_, options);

  clock_device_ = std::make_unique<SimClock>(*this);
  head_device_ = std::make_unique<SimHead>(*this);
  camera_device_ = std::make_unique<SimCameras>(*this);
  base_device_ = std::make_unique<SimBase>(*this);
}

KoalaSimulation::~KoalaSimulation() = default;

RenderedView KoalaSimulation::RenderTruth(Eye eye) {
  return renderer_->Render(world_->X_WCamera(ToString(eye)), config_.camera,
                           {.rgb = false, .depth = true, .ids = true});
}

void KoalaSimulation::Step() {
  head_->Update();
  plant_->Update();
  world_->Step();
  for (const auto& observer : observers_) observer(*world_);
}

void KoalaSimulation::Settle() {
  while (world_->now().time_since_epoch() < kSettleTime) Step();
  settled_ = world_->now().time_since_epoch();
  X_WO_ = hardware::ToPose(hardware::ToPose2(world_->X_WBody("base")));
}

hardware::Clock& KoalaSimulation::clock() { return *clock_device_; }
hardware::StereoHead& KoalaSimulation::head() { return *head_device_; }
hardware::CameraPair& KoalaSimulation::cameras() { return *camera_device_; }
hardware::MobileBase& KoalaSimulation::base() { return *base_device_; }

}  // namespace horopter::sim
