// SPDX-License-Identifier: Apache-2.0
//
// The contracts of hardware/interfaces, held by the simulated Koala.
#include "tests/hardware/interfaces/contract_camera_pair.h"
#include "tests/hardware/interfaces/contract_clock.h"
#include "tests/hardware/interfaces/contract_device.h"
#include "tests/hardware/interfaces/contract_mobile_base.h"
#include "tests/hardware/interfaces/contract_stereo_head.h"
#include "tests/sim/backend/yard.h"

namespace horopter::sim {
namespace {

using hardware::Clock;
using hardware::Duration;
using hardware::FromSeconds;

class SimTraits {
 public:
  static constexpr bool kLockstep = true;

  Clock& clock() { return simulation_.clock(); }

 protected:
  const KoalaSimulationConfig config_ = KoalaInYard();
  hardware::StageTimes times_;
  KoalaSimulation simulation_{config_, times_};
};

class ClockTraits : public SimTraits {
 public:
  std::optional<Duration> step() { return simulation_.world().step(); }
};

class HeadTraits : public SimTraits {
 public:
  hardware::StereoHead& device() { return simulation_.head(); }
  hardware::HeadAxisArray encoder_tolerance_rad() const {
    hardware::HeadAxisArray steps;
    steps.fill(config_.head.encoder_resolution_rad);
    return steps;
  }
  /// The pan axis crosses its range of 317.8 deg at 120 deg/s in 2.85 s.
  static Duration settle_time() { return FromSeconds(3); }
};

class BaseTraits : public SimTraits {
 public:
  hardware::MobileBase& device() { return simulation_.base(); }
  Duration deadman() const { return config_.plant.deadman; }
  /// From full speed to full speed backwards takes 1.15 s at 1 m/s^2.
  static Duration settle_time() { return FromSeconds(1.6); }
  static double speed_tolerance() { return 0.01; }
};

class CameraTraits : public SimTraits {
 public:
  static constexpr bool kSameInstant = true;

  hardware::CameraPair& device() { return simulation_.cameras(); }
  /// Simulated cameras show every physics step; this is a webcam's rate.
  static Duration frame_period() { return FromSeconds(0.04); }
  void ChangeView() {
    hardware::StereoHead& head = simulation_.head();
    ASSERT_TRUE(head.Configure().ok());
    ASSERT_TRUE(head.Activate().ok());
    ASSERT_TRUE(head.Command({{}, {0.3, 0.1}, {-0.2, 0.1}}).ok());
  }
};

}  // namespace
}  // namespace horopter::sim

namespace horopter::hardware {

using SimulatedDevices = testing::Types<sim::HeadTraits, sim::BaseTraits, sim::CameraTraits>;
INSTANTIATE_TYPED_TEST_SUITE_P(Simulated, ClockContract, sim::ClockTraits);
INSTANTIATE_TYPED_TEST_SUITE_P(Simulated, DeviceContract, SimulatedDevices);
INSTANTIATE_TYPED_TEST_SUITE_P(Simulated, StereoHeadContract, sim::HeadTraits);
INSTANTIATE_TYPED_TEST_SUITE_P(Simulated, MobileBaseContract, sim::BaseTraits);
INSTANTIATE_TYPED_TEST_SUITE_P(Simulated, CameraPairContract, sim::CameraTraits);

}  // namespace horopter::hardware
