// SPDX-License-Identifier: Apache-2.0
//
// The device contracts against kinematic fakes: proves that the suites can be met, and keeps them
// compiling where no backend is built.
#include "hardware/lockstep/lockstep_clock.h"
#include "tests/hardware/interfaces/contract_camera_pair.h"
#include "tests/hardware/interfaces/contract_device.h"
#include "tests/hardware/interfaces/contract_humanoid.h"
#include "tests/hardware/interfaces/contract_mobile_base.h"
#include "tests/hardware/interfaces/contract_stereo_head.h"
#include "tests/hardware/interfaces/kinematic_fakes.h"
#include "tests/hardware/interfaces/kinematic_humanoid.h"

namespace horopter::hardware {
namespace {

template <typename Fake>
class FakeTraits {
 public:
  static constexpr bool kLockstep = true;

  FakeTraits() {
    clock_.Start();
    self_.Bind();
  }
  Clock& clock() { return clock_; }
  Fake& device() { return device_; }
  void BreakLink() { device_.BreakLink(); }
  void MendLink() { device_.MendLink(); }

 private:
  LockstepClock clock_;
  LockstepClock::Participant self_ = clock_.AddParticipant("test");
  Fake device_{clock_};
};

class HeadTraits : public FakeTraits<KinematicHead> {
 public:
  static HeadAxisArray encoder_tolerance_rad() {
    HeadAxisArray steps;
    steps.fill(KinematicHead::kEncoderStep_rad);
    return steps;
  }
  static Duration settle_time() { return FromSeconds(1.5); }
};

class BaseTraits : public FakeTraits<KinematicBase> {
 public:
  static Duration deadman() { return KinematicBase::kDeadman; }
  static Duration settle_time() { return FromSeconds(0.5); }
  static double speed_tolerance() { return 0.005; }
};

class CameraTraits : public FakeTraits<FlatCameras> {
 public:
  static constexpr bool kSameInstant = true;
  static Duration frame_period() { return FlatCameras::kPeriod; }
  void ChangeView() { device().set_grey(200); }
};

class HumanoidTraits : public FakeTraits<KinematicHumanoid> {
 public:
  static Duration settle_time() { return FromSeconds(0.2); }
  static double velocity_tolerance() { return 0.02; }
};

using Devices = testing::Types<HeadTraits, BaseTraits, CameraTraits, HumanoidTraits>;
INSTANTIATE_TYPED_TEST_SUITE_P(Kinematic, DeviceContract, Devices);
INSTANTIATE_TYPED_TEST_SUITE_P(Kinematic, StereoHeadContract, HeadTraits);
INSTANTIATE_TYPED_TEST_SUITE_P(Kinematic, MobileBaseContract, BaseTraits);
INSTANTIATE_TYPED_TEST_SUITE_P(Kinematic, CameraPairContract, CameraTraits);
INSTANTIATE_TYPED_TEST_SUITE_P(Kinematic, HumanoidContract, HumanoidTraits);

}  // namespace
}  // namespace horopter::hardware
