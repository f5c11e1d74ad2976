// SPDX-License-Identifier: Apache-2.0
//
// The contracts of hardware/interfaces, held by the simulated NAO.
#include "tests/hardware/interfaces/contract_camera_pair.h"
#include "tests/hardware/interfaces/contract_clock.h"
#include "tests/hardware/interfaces/contract_device.h"
#include "tests/hardware/interfaces/contract_humanoid.h"
#include "tests/hardware/interfaces/contract_stereo_head.h"
#include "tests/sim/backend/nao_yard.h"
#include "tests/sim/backend/simulated.h"

namespace horopter::sim {
namespace {

using hardware::Duration;
using hardware::FromSeconds;

using NaoTraits = Simulated<NaoSimulation, NaoInYard>;
using NaoClockTraits = SimulatedClock<NaoTraits>;

class NaoHeadTraits : public SimulatedHead<NaoTraits> {
 public:
  /// The yaw crosses its range of 239 deg at 474 deg/s in 0.6 s.
  static Duration settle_time() { return FromSeconds(0.9); }
  static hardware::HeadAngles Reachable(const hardware::HeadAngles& target) {
    return NaoReachable(target);
  }
};

class NaoCameraTraits : public NaoTraits {
 public:
  static constexpr bool kSameInstant = true;

  hardware::CameraPair& device() { return simulation_.cameras(); }
  /// Simulated cameras show every physics step; this is the webcam's rate.
  static Duration frame_period() { return FromSeconds(0.0334); }
  void ChangeView() {
    hardware::StereoHead& head = simulation_.head();
    ASSERT_TRUE(head.Configure().ok());
    ASSERT_TRUE(head.Activate().ok());
    ASSERT_TRUE(head.Command({{0.5, 0.1}, {}, {}}).ok());
  }
};

class NaoBodyTraits : public NaoTraits {
 public:
  hardware::Humanoid& device() { return simulation_.humanoid(); }
  /// The rest of a step, and the one in which the velocity changes.
  static Duration settle_time() { return FromSeconds(0.86); }
  static double velocity_tolerance() { return 0.02; }
};

}  // namespace
}  // namespace horopter::sim

namespace horopter::hardware {

using SimulatedNao = testing::Types<sim::NaoHeadTraits, sim::NaoCameraTraits, sim::NaoBodyTraits>;
INSTANTIATE_TYPED_TEST_SUITE_P(SimulatedNao, ClockContract, sim::NaoClockTraits);
INSTANTIATE_TYPED_TEST_SUITE_P(SimulatedNao, DeviceContract, SimulatedNao);
INSTANTIATE_TYPED_TEST_SUITE_P(SimulatedNao, StereoHeadContract, sim::NaoHeadTraits);
INSTANTIATE_TYPED_TEST_SUITE_P(SimulatedNao, CameraPairContract, sim::NaoCameraTraits);
INSTANTIATE_TYPED_TEST_SUITE_P(SimulatedNao, HumanoidContract, sim::NaoBodyTraits);

}  // namespace horopter::hardware
