// SPDX-License-Identifier: Apache-2.0
//
// The contracts of hardware/interfaces, held by the simulated Koala.
#include "tests/hardware/interfaces/contract_camera_pair.h"
#include "tests/hardware/interfaces/contract_clock.h"
#include "tests/hardware/interfaces/contract_device.h"
#include "tests/hardware/interfaces/contract_mobile_base.h"
#include "tests/hardware/interfaces/contract_stereo_head.h"
#include "tests/sim/backend/simulated.h"
#include "tests/sim/backend/yard.h"

namespace horopter::sim {
namespace {

using hardware::Duration;
using hardware::FromSeconds;

using SimTraits = Simulated<KoalaSimulation, KoalaInYard>;
using ClockTraits = SimulatedClock<SimTraits>;

class HeadTraits : public SimulatedHead<SimTraits> {
 public:
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
