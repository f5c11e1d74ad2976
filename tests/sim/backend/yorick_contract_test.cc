// SPDX-License-Identifier: Apache-2.0
//
// The contracts of hardware/interfaces, held by the simulated Yorick.
#include "tests/hardware/interfaces/contract_camera_pair.h"
#include "tests/hardware/interfaces/contract_clock.h"
#include "tests/hardware/interfaces/contract_device.h"
#include "tests/hardware/interfaces/contract_stereo_head.h"
#include "tests/sim/backend/simulated.h"
#include "tests/sim/backend/yorick.h"

namespace horopter::sim {
namespace {

using hardware::Duration;
using hardware::FromSeconds;

using YorickTraits = Simulated<YorickSimulation, YorickAtTable>;
using YorickClockTraits = SimulatedClock<YorickTraits>;

class YorickHeadTraits : public SimulatedHead<YorickTraits> {
 public:
  /// The neck crosses its 180 deg at 430 deg/s in half a second.
  static Duration settle_time() { return FromSeconds(0.7); }
};

template <YorickPair pair>
class YorickCameraTraits : public YorickTraits {
 public:
  static constexpr bool kSameInstant = true;

  hardware::CameraPair& device() { return simulation_.cameras(pair); }
  /// Ideal simulated cameras show every physics step; this is PAL's rate.
  static Duration frame_period() { return FromSeconds(0.04); }
  void ChangeView() {
    hardware::StereoHead& head = simulation_.head();
    ASSERT_TRUE(head.Configure().ok());
    ASSERT_TRUE(head.Activate().ok());
    ASSERT_TRUE(head.Command({{0.2, 0.4}, {-0.1, 0}, {0.1, 0}}).ok());
  }
};

using PeripheralTraits = YorickCameraTraits<YorickPair::kPeripheral>;
using FovealTraits = YorickCameraTraits<YorickPair::kFoveal>;

}  // namespace
}  // namespace horopter::sim

namespace horopter::hardware {

using YorickDevices =
    testing::Types<sim::YorickHeadTraits, sim::PeripheralTraits, sim::FovealTraits>;
using YorickCameras = testing::Types<sim::PeripheralTraits, sim::FovealTraits>;
INSTANTIATE_TYPED_TEST_SUITE_P(Yorick, ClockContract, sim::YorickClockTraits);
INSTANTIATE_TYPED_TEST_SUITE_P(Yorick, DeviceContract, YorickDevices);
INSTANTIATE_TYPED_TEST_SUITE_P(Yorick, StereoHeadContract, sim::YorickHeadTraits);
INSTANTIATE_TYPED_TEST_SUITE_P(Yorick, CameraPairContract, YorickCameras);

}  // namespace horopter::hardware
